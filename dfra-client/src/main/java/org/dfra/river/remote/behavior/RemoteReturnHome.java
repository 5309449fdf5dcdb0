package org.dfra.river.remote.behavior;

import org.dfra.behavior.HomeGoal;
import org.dfra.behavior.ReturnHome;

/** What clients may call on the server of a behaviour that returns home. */
public interface RemoteReturnHome extends RemoteBehavior<HomeGoal>, ReturnHome {}
