/**
 * Sensors: the modules that measure the world.
 *
 * <p>Start at {@link org.dfra.flow.sensor.Sensor}. A kind of sensor is an interface here, its
 * readings are records with timestamp and frame. {@link org.dfra.flow.sensor.GPSSensor} is the
 * reference kind: a location sensor and a time sensor in one.
 *
 * <pre>
 *   own motion     LocationSensor, GPSSensor, OdometrySensor, AngularRateSensor
 *   surroundings   RangeSensor, CameraSensor
 *   own state      TimeSensor, BatterySensor
 * </pre>
 */
@NullMarked
package org.dfra.flow.sensor;

import org.jspecify.annotations.NullMarked;
