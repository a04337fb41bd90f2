// Width that a stem would have on screen at this end of its line, in pixels.
out float vWide;

// Half the picture's height in pixels.
uniform float lineScale;
