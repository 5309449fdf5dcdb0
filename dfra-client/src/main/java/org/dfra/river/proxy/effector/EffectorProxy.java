package org.dfra.river.proxy.effector;

import java.rmi.RemoteException;
import java.time.Duration;
import java.util.UUID;
import org.dfra.flow.effector.Command;
import org.dfra.flow.effector.CommandKey;
import org.dfra.flow.effector.CommandLease;
import org.dfra.flow.effector.Effector;
import org.dfra.flow.effector.EmergencyStopState;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.module.Identification;
import org.dfra.river.proxy.DeviceProxy;
import org.dfra.river.proxy.ModuleProxy;
import org.dfra.river.proxy.ProxyCommandLease;
import org.dfra.river.remote.RemoteModule;
import org.dfra.river.remote.effector.GrantedCommandLease;
import org.dfra.time.Scheduler;
import org.jspecify.annotations.Nullable;

/**
 * Smart proxy of an effector.
 *
 * @param <C> the effector's command type
 * @param <E> the effector's interface
 */
public abstract class EffectorProxy<C extends Command, E extends Effector<C>> extends DeviceProxy<E>
    implements Effector<C> {

  private static final long serialVersionUID = 1L;

  /** See {@link ModuleProxy#ModuleProxy}. */
  protected EffectorProxy(
      Class<E> kind, RemoteModule server, UUID id, Identification identification) {
    super(kind, server, id, identification);
  }

  /** {@inheritDoc} The proxy renews the lease as long as this program runs. */
  @Override
  public final CommandLease acquireCommandLease(Duration duration)
      throws LeaseRefusedException, RemoteException {
    long asked = Scheduler.system().nanos();
    CommandLease given = target().acquireCommandLease(duration);
    return given instanceof GrantedCommandLease leased
        ? ProxyCommandLease.startRenewing(
            identification().path(), leased, server(), duration, asked)
        : given;
  }

  @Override
  public final void execute(CommandKey key, C command) throws RemoteException {
    target().execute(key, command);
  }

  /** {@inheritDoc} Shortens the name: a request that is too long would be refused. */
  @Override
  public final EmergencyStopState emergencyStop(@Nullable String by) throws RemoteException {
    return target().emergencyStop(EmergencyStopState.requesterName(by));
  }

  @Override
  public final EmergencyStopState releaseEmergencyStop(@Nullable String by) throws RemoteException {
    return target().releaseEmergencyStop(EmergencyStopState.requesterName(by));
  }

  @Override
  public final EmergencyStopState emergencyStopState() throws RemoteException {
    return target().emergencyStopState();
  }
}
