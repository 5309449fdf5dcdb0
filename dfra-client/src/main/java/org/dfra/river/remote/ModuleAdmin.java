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
 * The administration of a running module: lets it join other lookup services, adds entries, lists
 * and revokes its leases, and shuts it down. A module's server returns it from {@code getAdmin()}.
 * Any client may query it. Methods that change the module are {@link Administrative}, and so are
 * those of {@link JoinAdmin} and {@link DestroyAdmin}.
 */
public interface ModuleAdmin extends JoinAdmin, DestroyAdmin, Remote {

  /** Every lease on the module, the oldest first. */
  @Idempotent
  List<LeaseStatus> leases() throws RemoteException;

  /**
   * The leases on remote modules that are held in this module's virtual machine, by it or by other
   * modules there.
   *
   * @return their handles, as the other modules' {@link #leases} list them
   */
  @Idempotent
  Set<LeaseHandle> heldLeases() throws RemoteException;

  /**
   * Ends a lease before it expires, against its holder's will. A remote holder learns this at its
   * next renewal, within a second, and does not request it again. A listener immediately receives
   * no more events.
   *
   * @param lease as {@link #leases} lists it
   * @return false if there is no such lease any more
   */
  @Administrative
  boolean revoke(LeaseHandle lease) throws RemoteException;

  /**
   * Stops the module until its next call. It leaves the lookup services, closes its device and
   * notifies the activation system. The next call starts it by its description at that time.
   * Returns when the module has stopped.
   *
   * @throws RemoteException if no answer came, or a part of it failed to close; its device may be
   *     open then
   */
  @Administrative
  void deactivate() throws RemoteException;

  /**
   * Why the module does not serve now, as the rest of a sentence: the failure, or what it waits
   * for.
   *
   * @return null while it serves
   */
  @Idempotent
  @Nullable String unreadiness() throws RemoteException;

  /**
   * The time by the clock of the module's host, for clock comparisons.
   *
   * @return UTC
   */
  @Idempotent
  Instant hostTime() throws RemoteException;

  /**
   * {@inheritDoc}
   *
   * <p>As {@link #deactivate}, but the activation system unregisters the module first. Returns when
   * that is done.
   */
  @Administrative
  @Override
  void destroy() throws RemoteException;
}
