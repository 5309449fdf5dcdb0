package org.dfra.river.proxy.behavior;

import java.util.UUID;
import org.dfra.behavior.HomeGoal;
import org.dfra.behavior.ReturnHome;
import org.dfra.module.Identification;
import org.dfra.river.proxy.ModuleProxy;
import org.dfra.river.remote.RemoteModule;

/** Smart proxy of a behaviour that returns home. */
public final class ReturnHomeProxy extends BehaviorProxy<HomeGoal, ReturnHome>
    implements ReturnHome {

  private static final long serialVersionUID = 1L;

  /** See {@link ModuleProxy#ModuleProxy}. */
  public ReturnHomeProxy(RemoteModule server, UUID id, Identification identification) {
    super(ReturnHome.class, server, id, identification);
  }
}
