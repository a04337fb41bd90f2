import '../site/tokens.css';
import './styles/layout.css';
import './styles/controls.css';
import './styles/parts.css';
import './styles/time.css';
import './styles/wind.css';
import './styles/sheet.css';
import './styles/dialogs.css';
import './styles/history.css';
import './styles/tree.css';
import { boot } from './boot.ts';

void boot(document.querySelector<HTMLElement>('.picture')!, document.querySelector<HTMLElement>('#interface')!);
