/**
 * Sensors: the modules that bring the world in.
 *
 * <p>Enter at {@link org.dfra.flow.sensor.Sensor}. A kind of sensor is an interface here, its
 * readings are records with timestamp and frame. {@link org.dfra.flow.sensor.GPSSensor} is the
 * reference kind: a location sensor and a time sensor in one.
 *
 * <pre>
 *   where it is    LocationSensor, GPSSensor, OdometrySensor, AngularRateSensor
 *   what is there  RangeSensor, CameraSensor
 *   how it is      TimeSensor, BatterySensor
 * </pre>
 */
@NullMarked
package org.dfra.flow.sensor;

import org.jspecify.annotations.NullMarked;
