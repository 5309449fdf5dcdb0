package org.dfra.river.call;

import java.rmi.server.ExportException;
import net.jini.export.Exporter;
import net.jini.id.Uuid;
import net.jini.id.UuidFactory;
import net.jini.jeri.BasicJeriExporter;
import net.jini.jeri.BasicObjectEndpoint;
import net.jini.jeri.InvocationLayerFactory;
import net.jini.jeri.ObjectEndpoint;
import net.jini.jeri.ServerEndpoint;

/**
 * JERI exporters. None uses distributed garbage collection: leases replace it. Those of a
 * configuration are refused if they do, since JERI then exports a further object at the same port,
 * whose calls nobody filters or authorizes.
 */
public final class JeriExporters {

  private static final String REFUSAL =
      " uses distributed garbage collection, whose calls no filter checks and no guard authorizes;"
          + " give BasicJeriExporter false as its third argument, or none";

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

  /**
   * An exporter whose exported object lets the virtual machine exit.
   *
   * @param id the object's ID in its proxies
   */
  public static Exporter notKeepingAlive(
      ServerEndpoint endpoint, InvocationLayerFactory factory, Uuid id) {
    return new BasicJeriExporter(endpoint, factory, false, false, id);
  }

  /**
   * Checks an exporter that a configuration names: that it uses no distributed garbage collection
   * and, in a team, that it encrypts and asks the guard.
   *
   * @param what it is to its user, such as its entry in the configuration
   * @return the exporter
   * @throws IllegalArgumentException if it must not be used; the message is a sentence that begins
   *     with {@code what}
   */
  public static Exporter requireNoDistributedGc(Exporter exporter, String what) {
    if (exporter instanceof BasicJeriExporter jeri && jeri.getEnableDGC()) {
      throw new IllegalArgumentException(what + REFUSAL);
    }
    EncryptedExport.require(exporter, what);
    return exporter;
  }

  /** As above, for an exporter that another one hides. */
  static void requireNoDistributedGc(ObjectEndpoint exported, Object impl) throws ExportException {
    if (exported instanceof BasicObjectEndpoint jeri && jeri.getEnableDGC()) {
      throw new ExportException("the exporter of " + impl.getClass().getName() + REFUSAL);
    }
  }
}
