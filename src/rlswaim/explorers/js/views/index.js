// All live views, by the name that Python sends in `payload.view`.
import { initialize } from '../page/sliders.js';
import ascent, { flight } from './ascent.js';
import bentVehicle, { height, loads } from './bent_vehicle.js';
import comparison from './comparison.js';
import controlSystem from './control_system.js';
import coupledVehicle, { paths, poles } from './coupled_vehicle.js';
import stationMap from './station_map.js';

const VIEWS = {
  ascent,
  'bent-vehicle': bentVehicle,
  comparison,
  'control-system': controlSystem,
  'coupled-vehicle': coupledVehicle,
  'station-map': stationMap,
};

const render = (context) => VIEWS[context.model.get('payload').view].render(context);

export { flight, height, initialize, loads, paths, poles, render };
