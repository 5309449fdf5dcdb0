package org.dfra.river.remote.effector;

import org.dfra.flow.effector.FlightCommand;
import org.dfra.flow.effector.FlightEffector;

/** What clients may call on the server of a flight controller. */
public interface RemoteFlightEffector extends RemoteEffector<FlightCommand>, FlightEffector {}
