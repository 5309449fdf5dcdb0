package org.dfra.river.server.effector;

import java.rmi.MarshalledObject;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationID;
import java.time.Duration;
import java.util.UUID;
import net.jini.core.lease.Lease;
import org.dfra.core.effector.EffectorImpl;
import org.dfra.core.effector.Helm;
import org.dfra.flow.effector.Command;
import org.dfra.flow.effector.CommandKey;
import org.dfra.flow.effector.CommandLease;
import org.dfra.flow.effector.Effector;
import org.dfra.flow.effector.StopState;
import org.dfra.lease.Holder;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.river.lease.ModuleLandlord;
import org.dfra.river.phoenix.stop.StopTarget;
import org.dfra.river.remote.LeasedUse;
import org.dfra.river.remote.effector.LeasedCommand;
import org.dfra.river.remote.effector.RemoteEffector;
import org.dfra.river.server.DeviceServer;
import org.dfra.river.server.ModuleActivation;
import org.dfra.river.server.ModuleServer;
import org.jspecify.annotations.Nullable;

/**
 * Activatable server of an effector. Whether a command is obeyed is decided behind it, by the
 * driver's {@link Helm}.
 *
 * @param <C> what the effector can be told
 * @param <E> the effector's interface
 */
public abstract class EffectorServer<C extends Command, E extends Effector<C>>
    extends DeviceServer<E> implements RemoteEffector<C>, StopTarget {

  /** See {@link ModuleServer#ModuleServer}. */
  protected EffectorServer(
      Class<E> kind, @Nullable ActivationID id, MarshalledObject<ModuleActivation> data)
      throws Exception {
    super(kind, EffectorImpl.class, id, data); // nothing else would guard it
  }

  private Helm helm() {
    return ((EffectorImpl<?>) module()).helm();
  }

  @Override
  public final UUID moduleId() {
    return id();
  }

  @Override
  public final String modulePath() {
    return path();
  }

  @Override
  public final CommandLease command(Duration duration) throws LeaseRefusedException {
    Lease[] lease = new Lease[1];
    CommandKey key =
        helm()
            .take(
                clientName(),
                whenOver -> {
                  lease[0] = grant(duration, Holder.COMMANDER, whenOver, whenOver);
                  return ModuleLandlord.id(lease[0]);
                });
    return new LeasedCommand(new LeasedUse(lease[0]), key);
  }

  @Override
  public final void obey(CommandKey key, C command) throws RemoteException {
    module().obey(key, command);
  }

  @Override
  public final StopState emergencyStop(@Nullable String by) throws RemoteException {
    return module().emergencyStop(by);
  }

  @Override
  public final StopState releaseStop(@Nullable String by) throws RemoteException {
    return module().releaseStop(by);
  }

  @Override
  public final StopState stopState() throws RemoteException {
    return module().stopState();
  }
}
