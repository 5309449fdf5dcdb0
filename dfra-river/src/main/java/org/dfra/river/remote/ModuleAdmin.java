package org.dfra.river.remote;

import com.sun.jini.admin.DestroyAdmin;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.time.Instant;
import java.util.List;
import java.util.Set;
import net.jini.admin.JoinAdmin;
import org.dfra.lease.LeaseHandle;
import org.dfra.lease.LeaseStatus;
import org.dfra.module.Administrative;
import org.dfra.module.Idempotent;
import org.jspecify.annotations.Nullable;

/**
 * What administrators may do to a module while it runs: have it join other lookup services, add
 * entries to its own, see and revoke its leases, and end it. A module's server gives it as its
 * {@code getAdmin()}. Questions are answered to anybody; what changes the module is {@link
 * Administrative}, and so is what {@link JoinAdmin} and {@link DestroyAdmin} change.
 */
public interface ModuleAdmin extends JoinAdmin, DestroyAdmin, Remote {

  /** Every lease on the module, the oldest first. */
  @Idempotent
  List<LeaseStatus> leases() throws RemoteException;

  /**
   * The leases on modules elsewhere that are held in this module's virtual machine, by it or by one
   * that shares it.
   *
   * @return their handles, as the other modules' {@link #leases} have them
   */
  @Idempotent
  Set<LeaseHandle> heldLeases() throws RemoteException;

  /**
   * Ends a lease before its time, against its holder's will. A holder elsewhere hears of it at its
   * next renewal, within a second, and does not come back by itself; a listener is told nothing
   * more at once.
   *
   * @param lease as {@link #leases} has it
   * @return false if there is no such lease any more
   */
  @Administrative
  boolean revoke(LeaseHandle lease) throws RemoteException;

  /**
   * Ends the module until it is called again: it leaves the lookup services, closes its device and
   * tells the activation system, which then starts it as it is described by then. Returns when that
   * is done.
   *
   * @throws RemoteException if no answer came, or a part of it did not close well; its device may
   *     be open then
   */
  @Administrative
  void deactivate() throws RemoteException;

  /**
   * Why the module does not serve now, as the rest of a sentence: what failed, or what it waits
   * for.
   *
   * @return null while it serves
   */
  @Idempotent
  @Nullable String unreadiness() throws RemoteException;

  /**
   * The time by the clock of the module's host, for those who compare clocks.
   *
   * @return UTC
   */
  @Idempotent
  Instant hostTime() throws RemoteException;

  /**
   * {@inheritDoc}
   *
   * <p>As {@link #deactivate}, and the activation system forgets the module before. Returns when
   * that is done.
   */
  @Administrative
  @Override
  void destroy() throws RemoteException;
}
