package org.dfra.river.remote.sensor;

import org.dfra.flow.sensor.GPSSensor;

/** What clients may call on the server of a satellite positioning receiver. */
public interface RemoteGPSSensor extends RemoteSensor, GPSSensor {}
