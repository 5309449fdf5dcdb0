package org.dfra.river.remote.sensor;

import org.dfra.flow.sensor.CameraSensor;

/** What clients may call on the server of a camera. */
public interface RemoteCameraSensor extends RemoteSensor, CameraSensor {}
