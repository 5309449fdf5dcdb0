package org.dfra.river.remote;

import org.dfra.flow.sensor.Sensor;

/** What clients may call on any sensor's server. */
public interface RemoteSensor extends RemoteModule, RemoteExamination, Sensor {}
