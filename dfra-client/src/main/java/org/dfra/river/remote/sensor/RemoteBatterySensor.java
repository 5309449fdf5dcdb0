package org.dfra.river.remote.sensor;

import org.dfra.flow.sensor.BatterySensor;

/** What clients may call on the server of a battery's sensor. */
public interface RemoteBatterySensor extends RemoteSensor, BatterySensor {}
