package org.dfra.river.lease;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import com.sun.jini.landlord.Landlord;
import com.sun.jini.landlord.LandlordUtil;
import com.sun.jini.landlord.LocalLandlord;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.server.ExportException;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Supplier;
import net.jini.core.lease.LeaseDeniedException;
import net.jini.core.lease.UnknownLeaseException;
import net.jini.export.Exporter;
import net.jini.id.Uuid;
import org.dfra.river.identity.ChannelIdentity;
import org.dfra.river.identity.CurrentIdentity;
import org.jspecify.annotations.Nullable;

/**
 * The landlord that all modules of this virtual machine share, so that a client renews its leases
 * on all of them in one call. It grants nothing itself: each module's {@link ModuleLandlord} does,
 * and this one asks it.
 *
 * <p>There is one for each host name that modules' proxies carry. It is exported while at least one
 * module is.
 */
public final class ProcessLandlord implements Landlord, LocalLandlord {

  /** Modules of robots that share a virtual machine do not share the landlord. */
  private record Shareable(String host, @Nullable ChannelIdentity identity) {}

  @GuardedBy("ProcessLandlord.class")
  private static final Map<Shareable, ProcessLandlord> BY_HOST = new HashMap<>();

  private final List<ModuleLandlord> modules = new CopyOnWriteArrayList<>();

  @GuardedBy("ProcessLandlord.class")
  private @Nullable Exporter exporter;

  @GuardedBy("ProcessLandlord.class")
  private @Nullable Landlord proxy;

  private ProcessLandlord() {}

  /**
   * An exporter for one {@link ModuleLandlord}: it adds it to the shared landlord, whose proxy it
   * returns.
   *
   * @param host address or name that the module's proxies carry
   * @param exporters creates the exporter of the shared landlord if it is not exported
   */
  public static Exporter exporterAt(String host, Supplier<Exporter> exporters) {
    return new Exporter() {

      private final Shareable at = new Shareable(host, CurrentIdentity.get());
      private @Nullable ModuleLandlord exported;

      @Override
      public Remote export(Remote landlord) throws ExportException {
        if (!(landlord instanceof ModuleLandlord module) || exported != null) {
          throw new ExportException(
              "this exporter exports one ModuleLandlord once, and not " + landlord);
        }
        Remote shared = add(at, module, exporters);
        exported = module;
        return shared;
      }

      @Override
      public boolean unexport(boolean force) {
        @Nullable ModuleLandlord gone = exported;
        if (gone != null) {
          exported = null;
          remove(at, gone);
        }
        return true;
      }
    };
  }

  private static synchronized Landlord add(
      Shareable at, ModuleLandlord module, Supplier<Exporter> exporters) throws ExportException {
    ProcessLandlord shared = BY_HOST.computeIfAbsent(at, each -> new ProcessLandlord());
    @Nullable Landlord known = shared.proxy;
    if (known == null) {
      Exporter fresh = exporters.get();
      known = (Landlord) fresh.export(shared);
      shared.proxy = known;
      shared.exporter = fresh;
    }
    shared.modules.add(module);
    return known;
  }

  private static synchronized void remove(Shareable at, ModuleLandlord module) {
    @Nullable ProcessLandlord shared = BY_HOST.get(at);
    if (shared != null && shared.modules.remove(module) && shared.modules.isEmpty()) {
      BY_HOST.remove(at);
      @Nullable Exporter last = shared.exporter;
      if (last != null) {
        boolean unused = last.unexport(true);
      }
    }
  }

  private ModuleLandlord owner(Uuid cookie) throws UnknownLeaseException {
    for (ModuleLandlord each : modules) {
      if (each.knows(cookie)) {
        return each;
      }
    }
    throw new UnknownLeaseException("no module here knows such a lease; it has expired");
  }

  @Override
  public long renew(Uuid cookie, long duration) throws LeaseDeniedException, UnknownLeaseException {
    return owner(cookie).renew(cookie, duration);
  }

  @Override
  public void cancel(Uuid cookie) throws UnknownLeaseException {
    owner(cookie).cancel(cookie);
  }

  /**
   * {@inheritDoc}
   *
   * @throws IllegalArgumentException if they are more than {@value
   *     ModuleLandlord#MAX_LEASES_PER_CALL}
   */
  @Override
  public RenewResults renewAll(Uuid[] cookies, long[] durations) throws RemoteException {
    ModuleLandlord.checkCount("the modules of this process", cookies);
    return LandlordUtil.renewAll(this, cookies, durations);
  }

  /**
   * {@inheritDoc}
   *
   * @throws IllegalArgumentException as {@link #renewAll}
   */
  @Override
  @SuppressWarnings("rawtypes") // as River declares it
  public @Nullable Map cancelAll(Uuid[] cookies) throws RemoteException {
    ModuleLandlord.checkCount("the modules of this process", cookies);
    return LandlordUtil.cancelAll(this, cookies);
  }

  @Override
  public String toString() {
    return "the landlord of " + modules.size() + " modules";
  }
}
