// What a user's own tank takes, once there is one.
export { readTankFiles } from "../tank_files.js";
export { TankSet } from "../tank_set.js";
