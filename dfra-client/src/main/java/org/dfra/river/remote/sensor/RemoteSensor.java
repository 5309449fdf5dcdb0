package org.dfra.river.remote.sensor;

import org.dfra.flow.sensor.Sensor;
import org.dfra.river.remote.RemoteDevice;

/** What clients may call on any sensor's server. */
public interface RemoteSensor extends RemoteDevice, Sensor {}
