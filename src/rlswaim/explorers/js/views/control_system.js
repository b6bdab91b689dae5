// One control system under its sliders.
import { initialize } from '../page/sliders.js';
import { Workbench } from './workbench.js';

function render({ model, el }) {
  return new Workbench(model, el).stop;
}

export default { initialize, render };
