import './page.css';
import { boot } from './boot.ts';

void boot(document.querySelector<HTMLElement>('.picture')!, document.querySelector<HTMLElement>('#interface')!);
