package org.dfra.river.proxy.behavior;

import java.rmi.RemoteException;
import java.util.UUID;
import org.dfra.behavior.Behavior;
import org.dfra.behavior.BehaviorStatus;
import org.dfra.behavior.Goal;
import org.dfra.module.Identification;
import org.dfra.river.proxy.ModuleProxy;
import org.dfra.river.proxy.schema.SchemaProxy;
import org.dfra.river.remote.RemoteModule;

/**
 * Smart proxy of a behaviour.
 *
 * @param <G> the behaviour's goal type
 * @param <B> the behaviour's interface
 */
public abstract class BehaviorProxy<G extends Goal, B extends Behavior<G>> extends SchemaProxy<B>
    implements Behavior<G> {

  private static final long serialVersionUID = 1L;

  /** See {@link ModuleProxy#ModuleProxy}. */
  protected BehaviorProxy(
      Class<B> kind, RemoteModule server, UUID id, Identification identification) {
    super(kind, server, id, identification);
  }

  @Override
  public final UUID pursue(G goal) throws RemoteException {
    return target().pursue(goal);
  }

  @Override
  public final UUID pursueUnattended(G goal) throws RemoteException {
    return target().pursueUnattended(goal);
  }

  @Override
  public final BehaviorStatus status() throws RemoteException {
    return target().status();
  }

  @Override
  public final void pause() throws RemoteException {
    target().pause();
  }

  @Override
  public final void pauseUnattended() throws RemoteException {
    target().pauseUnattended();
  }

  @Override
  public final void resume() throws RemoteException {
    target().resume();
  }

  @Override
  public final void resumeUnattended() throws RemoteException {
    target().resumeUnattended();
  }

  @Override
  public final void cancel() throws RemoteException {
    target().cancel();
  }

  @Override
  public final void cancel(UUID goal) throws RemoteException {
    target().cancel(goal);
  }

  @Override
  public final void cancelUnattended(UUID goal) throws RemoteException {
    target().cancelUnattended(goal);
  }
}
