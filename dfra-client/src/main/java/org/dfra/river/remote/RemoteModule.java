package org.dfra.river.remote;

import java.rmi.Remote;
import java.rmi.RemoteException;
import java.time.Duration;
import net.jini.admin.Administrable;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleListener;
import org.dfra.event.Subscription;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.lease.ModuleLease;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.Idempotent;
import org.dfra.module.Module;

/** What clients may call on any module's server. */
public interface RemoteModule extends Module, Remote, Administrable {

  /** The longest wait of one call at the server; proxies wait longer in several calls. */
  Duration MAX_CALL_WAIT = Duration.ofSeconds(1);

  /**
   * {@inheritDoc}
   *
   * <p>One call waits at most {@link #MAX_CALL_WAIT}, so that it returns before its deadline.
   */
  @Override
  @Idempotent
  Readiness awaitReadiness(Duration patience) throws RemoteException;

  /**
   * Registers a listener under a lease. A registered listener is registered again.
   *
   * @param listener a {@link RemoteModuleListener}
   * @return a {@link GrantedSubscription}
   * @throws IllegalArgumentException if the listener is not remote
   */
  @Override
  Subscription subscribe(ModuleListener listener, DeliveryPolicy policy) throws RemoteException;

  /**
   * {@inheritDoc}
   *
   * @return a {@link GrantedModuleLease}
   */
  @Override
  ModuleLease acquireLease(Duration duration) throws LeaseRefusedException, RemoteException;
}
