package org.dfra.river.remote.behavior;

import org.dfra.behavior.GoToWaypoint;
import org.dfra.behavior.LegGoal;

/** What clients may call on the server of a behaviour that goes to a waypoint. */
public interface RemoteGoToWaypoint extends RemoteBehavior<LegGoal>, GoToWaypoint {}
