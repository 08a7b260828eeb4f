// What a user's own tank takes, once there is one.
export { readTankFiles } from "../own_tank/tank_files.js";
export { TankSet } from "../own_tank/tank_set.js";
