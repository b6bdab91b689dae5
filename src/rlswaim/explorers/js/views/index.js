// All live views, by the names that Python sends in `payload.view`, and what tests ask of them.
import { height, loads } from '../maths/bent_vehicle_forces.js';
import { paths, poles } from '../maths/coupled_poles.js';
import { flight } from '../maths/flights.js';
import { bound } from '../maths/peak_bound.js';
import { initialize } from '../page/sliders.js';
import { render as ascent } from './ascent.js';
import { render as bentVehicle } from './bent_vehicle.js';
import { render as comparison } from './comparison.js';
import { render as coupledVehicle } from './coupled_vehicle.js';
import { render as frozenPoles } from './frozen_poles.js';
import { render as movingLoop } from './moving_loop.js';
import { render as ownLoop } from './own_loop.js';
import { render as peakBound } from './peak_bound.js';
import { render as stationMap } from './station_map.js';
import { render as workbench } from './workbench.js';

/** @import { Context } from '../types.d.ts' */

/** @type {Record<string, (context: Context) => () => void>} */
const VIEWS = {
  ascent,
  'bent-vehicle': bentVehicle,
  comparison,
  'coupled-vehicle': coupledVehicle,
  'frozen-poles': frozenPoles,
  'moving-loop': movingLoop,
  'own-loop': ownLoop,
  'peak-bound': peakBound,
  'station-map': stationMap,
  workbench,
};

/** Puts a view into its element; returns what takes it away. @param {Context} context */
const render = (context) => VIEWS[context.model.get('payload').view](context);

export { bound, flight, height, initialize, loads, paths, poles, render };
