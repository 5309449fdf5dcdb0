package org.dfra.river.server.behavior;

import java.rmi.MarshalledObject;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationID;
import java.util.Objects;
import java.util.UUID;
import org.dfra.behavior.Behavior;
import org.dfra.behavior.BehaviorStatus;
import org.dfra.behavior.Goal;
import org.dfra.core.behavior.BehaviorImpl;
import org.dfra.river.remote.behavior.RemoteBehavior;
import org.dfra.river.server.ModuleActivation;
import org.dfra.river.server.ModuleServer;
import org.dfra.river.server.schema.SchemaServer;
import org.jspecify.annotations.Nullable;

/**
 * Activatable server of a behaviour.
 *
 * @param <G> the behaviour's goal type
 * @param <B> the behaviour's interface
 */
public abstract class BehaviorServer<G extends Goal, B extends Behavior<G>> extends SchemaServer<B>
    implements RemoteBehavior<G> {

  private volatile @Nullable GoalRequester requester; // from the start on

  /** See {@link ModuleServer#ModuleServer}. */
  protected BehaviorServer(
      Class<B> kind, @Nullable ActivationID id, MarshalledObject<ModuleActivation> data)
      throws Exception {
    super(kind, BehaviorImpl.class, id, data);
  }

  @Override
  protected final AutoCloseable beforeExport() {
    GoalRequester watching = new GoalRequester(path(), (BehaviorImpl<?>) module(), getClass());
    requester = watching;
    return watching;
  }

  private GoalRequester requester() {
    return Objects.requireNonNull(requester, "the server is not started");
  }

  @Override
  public final UUID pursue(G goal) throws RemoteException {
    return requester().by(() -> module().pursue(goal));
  }

  @Override
  public final UUID pursueUnattended(G goal) throws RemoteException {
    return requester().by(() -> module().pursueUnattended(goal));
  }

  @Override
  public final BehaviorStatus status() throws RemoteException {
    return module().status();
  }

  @Override
  public final void pause() throws RemoteException {
    module().pause();
  }

  @Override
  public final void pauseUnattended() throws RemoteException {
    module().pauseUnattended();
  }

  @Override
  public final void resume() throws RemoteException {
    boolean unused = requester().by(() -> resumed(module()::resume));
  }

  @Override
  public final void resumeUnattended() throws RemoteException {
    boolean unused = requester().byProgram(() -> resumed(module()::resumeUnattended));
  }

  private static boolean resumed(Resumption resumption) throws RemoteException {
    resumption.call();
    return true;
  }

  @FunctionalInterface
  private interface Resumption {
    void call() throws RemoteException;
  }

  @Override
  public final void cancel() throws RemoteException {
    module().cancel();
  }

  @Override
  public final void cancel(UUID goal) throws RemoteException {
    module().cancel(goal);
  }

  @Override
  public final void cancelUnattended(UUID goal) throws RemoteException {
    module().cancelUnattended(goal);
  }
}
