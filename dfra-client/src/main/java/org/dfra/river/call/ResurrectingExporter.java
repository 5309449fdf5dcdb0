package org.dfra.river.call;

import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Proxy;
import java.rmi.Remote;
import java.rmi.activation.ActivationID;
import java.rmi.server.ExportException;
import java.util.LinkedHashSet;
import java.util.Set;
import net.jini.core.constraint.RemoteMethodControl;
import net.jini.export.Exporter;
import net.jini.security.proxytrust.ProxyTrust;
import net.jini.security.proxytrust.TrustEquivalence;
import org.jspecify.annotations.Nullable;

/**
 * Exports an activatable object: its proxy activates the object again after it has ended.
 *
 * <p>Works like River's {@code ActivationExporter}, but also for objects with a package-private
 * remote interface, such as those of River's own services. On current JDKs these get non-public
 * proxy classes, which River's exporter refuses.
 */
public final class ResurrectingExporter implements Exporter {

  private final ActivationID id;
  private final Exporter underlying;

  /**
   * @param id the identifier under which the activation system knows the object
   * @param underlying exports the active object
   * @throws IllegalArgumentException if that uses distributed garbage collection
   */
  public ResurrectingExporter(ActivationID id, Exporter underlying) {
    this.id = java.util.Objects.requireNonNull(id, "id");
    this.underlying =
        JeriExporters.requireNoDistributedGc(
            java.util.Objects.requireNonNull(underlying, "underlying"), "the underlying exporter");
  }

  @Override
  public Remote export(Remote impl) throws ExportException {
    Remote live = underlying.export(impl);
    try {
      return proxy(id, live);
    } catch (IllegalArgumentException e) {
      underlying.unexport(true);
      throw new ExportException("no proxy can be made for " + impl.getClass().getName(), e);
    }
  }

  @Override
  public boolean unexport(boolean force) {
    return underlying.unexport(force);
  }

  /** Creates a proxy for an activatable object, with its live proxy, or null if that is unknown. */
  static Remote proxy(ActivationID id, Remote live) {
    Set<Class<?>> interfaces = new LinkedHashSet<>();
    boolean constrainable = live instanceof RemoteMethodControl;
    for (@Nullable Class<?> type = live.getClass(); type != null; type = type.getSuperclass()) {
      for (Class<?> each : type.getInterfaces()) {
        if (!(constrainable && each == ProxyTrust.class)) {
          interfaces.add(each);
        }
      }
    }
    interfaces.add(TrustEquivalence.class);
    InvocationHandler handler = new ResurrectingHandler(id, live);
    return (Remote)
        Proxy.newProxyInstance(
            live.getClass().getClassLoader(), interfaces.toArray(Class<?>[]::new), handler);
  }
}
