package org.dfra.river.server.behavior;

import java.rmi.MarshalledObject;
import java.rmi.activation.ActivationID;
import org.dfra.behavior.HomeGoal;
import org.dfra.behavior.ReturnHome;
import org.dfra.river.remote.behavior.RemoteReturnHome;
import org.dfra.river.server.ModuleActivation;
import org.dfra.river.server.ModuleServer;
import org.jspecify.annotations.Nullable;

/** Activatable server of a behaviour that returns home. */
public final class ReturnHomeServer extends BehaviorServer<HomeGoal, ReturnHome>
    implements RemoteReturnHome {

  /** See {@link ModuleServer#ModuleServer}. */
  public ReturnHomeServer(@Nullable ActivationID id, MarshalledObject<ModuleActivation> data)
      throws Exception {
    super(ReturnHome.class, id, data);
  }
}
