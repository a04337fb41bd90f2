import ts from 'typescript';

/** Attributes of a template that a reader sees or hears. */
const READ =
  /^\.?(aria-label|aria-description|aria-roledescription|aria-valuetext|aria-placeholder|title|placeholder|alt|label)$/;
/** Properties of objects and arguments of calls that end up on the screen. */
const SHOWN_PROPERTIES = new Set(['label', 'title', 'legend', 'help', 'hint', 'placeholder']);
const SHOWN_CALLS = new Set(['say', 'notify', 'tell', 'FileError', 'of', 'toggle', 'fold', 'plotFigure']);

/** Units, names of keys and single letters are symbols, not words. */
const UNITS = /(?<![\p{L}\d])(m\/s|1\/s|ms|px|Esc|Hz|kB|MB|k|dpi)(?![\p{L}\d])/gu;

/** Whether a text says something: two letters that stand together, once units are taken out. */
export const says = (text: string): boolean =>
  /\p{L}{2}/u.test(text.replace(/&[a-z]+;|&#\w+;/g, ' ').replace(UNITS, ' '));

/** Words that stand in the code of a file and not in words/: `line: the text`. */
export function inlineWords(source: string, file: string): string[] {
  const tree = ts.createSourceFile(file, source, ts.ScriptTarget.Latest, true);
  const found: string[] = [];
  const tell = (node: ts.Node, text: string): void => {
    const { line } = tree.getLineAndCharacterOfPosition(node.getStart(tree));
    const short = text.replace(/\s+/g, ' ').trim().slice(0, 60);
    found.push(`${file}:${line + 1}: ${short}`);
  };

  /** The texts that an expression can become; what it compares or calls with is none. */
  const check = (node: ts.Expression): void => {
    if (ts.isStringLiteralLike(node)) {
      if (says(node.text)) tell(node, node.text);
    } else if (ts.isTemplateExpression(node)) {
      const own = [node.head.text, ...node.templateSpans.map((s) => s.literal.text)];
      for (const text of own) if (says(text)) tell(node, text);
      for (const span of node.templateSpans) check(span.expression);
    } else if (ts.isConditionalExpression(node)) {
      check(node.whenTrue);
      check(node.whenFalse);
    } else if (ts.isParenthesizedExpression(node) || ts.isAsExpression(node)) {
      check(node.expression);
    } else if (ts.isBinaryExpression(node)) {
      const { kind } = node.operatorToken;
      const result =
        kind === ts.SyntaxKind.PlusToken ||
        kind === ts.SyntaxKind.BarBarToken ||
        kind === ts.SyntaxKind.QuestionQuestionToken;
      if (result) check(node.left);
      if (result || kind === ts.SyntaxKind.AmpersandAmpersandToken) check(node.right);
    } else if (ts.isArrayLiteralExpression(node)) {
      for (const element of node.elements) if (ts.isExpression(element)) check(element);
    }
  };

  /** A lit template: its text nodes and the attributes that are read, with the expressions that stand in them. */
  const template = (literal: ts.TemplateLiteral): void => {
    const spans = ts.isTemplateExpression(literal) ? literal.templateSpans : [];
    const texts = ts.isTemplateExpression(literal)
      ? [literal.head.text, ...spans.map((s) => s.literal.text)]
      : [literal.text];
    let inTag = false;
    let quote = '';
    let attribute = '';
    let run = '';
    const end = (): void => {
      if (says(run)) tell(literal, run);
      run = '';
    };
    texts.forEach((text, i) => {
      for (let at = 0; at < text.length; at++) {
        const letter = text[at]!;
        if (!inTag) {
          if (letter === '<') {
            end();
            inTag = true;
            attribute = '';
          } else run += letter;
        } else if (quote !== '') {
          if (letter === quote) {
            if (READ.test(attribute)) end();
            run = '';
            quote = '';
            attribute = '';
          } else run += letter;
        } else if (letter === '"' || letter === "'") {
          quote = letter;
          run = '';
        } else if (letter === '>') {
          inTag = false;
          run = '';
          attribute = '';
        } else if (/\s/.test(letter)) attribute = '';
        else if (letter !== '=') attribute += letter;
      }
      const span = spans[i];
      if (!span) return;
      // One word does not go on behind an expression.
      if (!inTag || (quote !== '' && READ.test(attribute))) end();
      if (!inTag || READ.test(attribute)) check(span.expression);
      if (inTag && quote === '') attribute = '';
    });
    if (!inTag) end();
  };

  const visit = (node: ts.Node): void => {
    if (ts.isTaggedTemplateExpression(node) && /^(html|svg)$/.test(node.tag.getText(tree))) template(node.template);
    if (ts.isPropertyAssignment(node) && SHOWN_PROPERTIES.has(node.name.getText(tree))) check(node.initializer);
    if (ts.isCallExpression(node) || ts.isNewExpression(node)) {
      const name = node.expression.getText(tree).split('.').at(-1)!;
      if (SHOWN_CALLS.has(name)) {
        // Names and ids have no space; sentences do.
        for (const argument of node.arguments ?? []) if (/\s/.test(argument.getText(tree))) check(argument);
      }
      const [first, second] = node.arguments ?? [];
      if (name === 'setAttribute' && first && second && ts.isStringLiteral(first) && READ.test(first.text))
        check(second);
    }
    ts.forEachChild(node, visit);
  };
  visit(tree);
  return [...new Set(found)];
}
