// All tests: those of the parts of the extension, and the colours of templates.

import "./command.test.ts";
import "./extension.test.ts";
import "./follower.test.ts";
import "./frame.test.ts";
import "./grammar.test.ts";
import "./living.test.ts";
import "./mechanisms.test.ts";
import "./panel.test.ts";
