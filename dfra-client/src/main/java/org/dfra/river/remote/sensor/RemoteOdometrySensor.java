package org.dfra.river.remote.sensor;

import org.dfra.flow.sensor.OdometrySensor;

/** What clients may call on the server of an odometry sensor. */
public interface RemoteOdometrySensor extends RemoteSensor, OdometrySensor {}
