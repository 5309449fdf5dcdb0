package org.dfra.river.remote.behavior;

import org.dfra.behavior.FollowWaypoints;
import org.dfra.behavior.PathGoal;

/** What clients may call on the server of a behaviour that follows waypoints. */
public interface RemoteFollowWaypoints extends RemoteBehavior<PathGoal>, FollowWaypoints {}
