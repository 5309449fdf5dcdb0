package org.dfra.river.call;

import net.jini.export.Exporter;
import net.jini.id.Uuid;
import net.jini.id.UuidFactory;
import net.jini.jeri.BasicJeriExporter;
import net.jini.jeri.InvocationLayerFactory;
import net.jini.jeri.ServerEndpoint;

/** JERI exporters. None uses distributed garbage collection: leases replace it. */
public final class JeriExporters {

  private JeriExporters() {}

  /** An exporter whose exported object keeps the virtual machine running. */
  public static Exporter keepingAlive(ServerEndpoint endpoint, InvocationLayerFactory factory) {
    return keepingAlive(endpoint, factory, UuidFactory.generate());
  }

  /**
   * An exporter whose exported object keeps the virtual machine running.
   *
   * @param id the object's ID in its proxies; the same after a restart if they are to remain valid
   */
  public static Exporter keepingAlive(
      ServerEndpoint endpoint, InvocationLayerFactory factory, Uuid id) {
    return new BasicJeriExporter(endpoint, factory, false, true, id);
  }

  /**
   * An exporter whose exported object lets the virtual machine exit, such as a client's listener.
   */
  public static Exporter notKeepingAlive(ServerEndpoint endpoint, InvocationLayerFactory factory) {
    return new BasicJeriExporter(endpoint, factory, false, false);
  }
}
