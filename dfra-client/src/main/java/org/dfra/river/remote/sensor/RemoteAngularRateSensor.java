package org.dfra.river.remote.sensor;

import org.dfra.flow.sensor.AngularRateSensor;

/** What clients may call on the server of a rate gyro. */
public interface RemoteAngularRateSensor extends RemoteSensor, AngularRateSensor {}
