package org.dfra.river.remote.sensor;

import org.dfra.flow.sensor.RangeSensor;

/** What clients may call on the server of a range sensor. */
public interface RemoteRangeSensor extends RemoteSensor, RangeSensor {}
