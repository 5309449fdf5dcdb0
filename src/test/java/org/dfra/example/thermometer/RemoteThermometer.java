package org.dfra.example.thermometer;

import org.dfra.river.remote.sensor.RemoteSensor;

/** What clients may call on the server of a thermometer. */
public interface RemoteThermometer extends RemoteSensor, Thermometer {}
