package org.dfra.river.call;

import java.rmi.Remote;
import java.rmi.server.ExportException;
import net.jini.export.Exporter;
import net.jini.jeri.BasicJeriExporter;
import net.jini.jeri.BasicObjectEndpoint;
import net.jini.jeri.ObjectEndpoint;
import org.dfra.river.identity.CurrentIdentity;
import org.dfra.river.transport.TransportEndpoint;
import org.dfra.river.transport.TransportServerEndpoint;

/** Keeps a process that has joined a team from exporting what others could call without a key. */
public final class EncryptedExport {

  private EncryptedExport() {}

  /**
   * Refuses a way of exporting.
   *
   * @param what it is, such as {@code JRMP}
   * @throws IllegalStateException if this process has joined a team
   */
  public static void require(String what) {
    if (CurrentIdentity.isSecure()) {
      throw new IllegalStateException(
          what
              + " does not encrypt, and this computer has joined a team; export with"
              + " Endpoints.tcp, which does");
    }
  }

  /**
   * Refuses an endpoint.
   *
   * @param exported where an object is exported
   * @throws ExportException if this process has joined a team and the endpoint does not encrypt
   */
  static void require(ObjectEndpoint exported, Remote impl) throws ExportException {
    boolean isOurs =
        exported instanceof BasicObjectEndpoint jeri
            && jeri.getEndpoint() instanceof TransportEndpoint;
    if (CurrentIdentity.isSecure() && !isOurs) {
      throw new ExportException(
          impl.getClass().getName()
              + " is exported on "
              + exported
              + ", which does not encrypt, and this computer has joined a team; export with"
              + " Endpoints.tcp, which does");
    }
  }

  /**
   * Refuses an exporter that a configuration names.
   *
   * @param what it is to its user, such as its entry in the configuration
   * @throws IllegalArgumentException if this process has joined a team, and the exporter does not
   *     encrypt or asks no guard
   */
  static void require(Exporter exporter, String what) {
    boolean isGuarded =
        exporter instanceof ResurrectingExporter // it is checked by the one that it wraps
            || (exporter instanceof BasicJeriExporter jeri
                && jeri.getServerEndpoint() instanceof TransportServerEndpoint
                && jeri.getInvocationLayerFactory() instanceof DeadlineILFactory);
    if (CurrentIdentity.isSecure() && !isGuarded) {
      throw new IllegalArgumentException(
          what
              + " does not encrypt or asks no guard, and this computer has joined a team; use"
              + " Endpoints.tcp with DeadlineILFactory");
    }
  }
}
