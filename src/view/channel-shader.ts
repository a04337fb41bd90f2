/** What a fragment shader needs to show a channel in place of its own colour. */
export const CHANNEL_FRAGMENT = `#ifdef CHANNEL_VIEW
in vec3 vChannel;
#endif`;

/** Put where the colour is known. Channels are numbers as a screen shows them; light falls on linear ones. */
export const CHANNEL_DIFFUSE = `#ifdef CHANNEL_VIEW
diffuseColor.rgb = pow(vChannel, vec3(2.2));
#endif`;
