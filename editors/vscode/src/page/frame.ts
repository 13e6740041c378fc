// The document of the panel, and pages as they are put into it.

/** A word that scripts of one panel have, and nothing else. */
export function newNonce(): string {
  const bytes = crypto.getRandomValues(new Uint8Array(18));
  return Buffer.from(bytes).toString("base64url");
}

/** Returns the policy of a panel: nothing is loaded from elsewhere, and only scripts with the nonce run. */
export function policy(nonce: string): string {
  const rules = [
    "default-src 'none'",
    `script-src 'nonce-${nonce}'`,
    "style-src 'unsafe-inline'",
    "img-src data: blob:",
    "connect-src blob:",
    "base-uri 'none'",
    "form-action 'none'",
  ];
  return rules.join("; ");
}

const STYLE = `
html, body { height: 100%; margin: 0; padding: 0; overflow: hidden; }
body { display: flex; flex-direction: column; }
#pages { position: relative; flex: 1; }
iframe { position: absolute; inset: 0; width: 100%; height: 100%; border: 0; }
iframe[data-coming] { visibility: hidden; }
#mistakes {
  max-height: 50vh; margin: 0; padding: 8px 12px; overflow: auto; white-space: pre-wrap;
  color: var(--vscode-inputValidation-warningForeground, inherit);
  background: var(--vscode-inputValidation-warningBackground);
  border-bottom: 1px solid var(--vscode-inputValidation-warningBorder);
  font-family: var(--vscode-editor-font-family, monospace);
}
#mistakes[hidden] { display: none; }
`;

/** Returns the document of the panel with its script. */
export function panelDocument(nonce: string, script: string): string {
  return `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="${policy(nonce)}">
<title>Living page</title>
<style>${STYLE}</style>
</head>
<body>
<pre id="mistakes" role="alert" hidden></pre>
<div id="pages"></div>
<script nonce="${nonce}">${script.replaceAll("</script", "<\\/script")}</script>
</body>
</html>
`;
}

/** The begin of a script in a page of the command: in the text of data there is no such sign. */
const SCRIPT = /<script(?=[\s>])/g;

/** Returns a page whose scripts have the nonce of the panel. */
export function framed(page: string, nonce: string): string {
  return page.replace(SCRIPT, `<script nonce="${nonce}"`);
}
