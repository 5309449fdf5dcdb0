package org.dfra.river.server;

import java.rmi.activation.ActivationID;
import net.jini.export.Exporter;
import net.jini.jrmp.JrmpExporter;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.EncryptedExport;
import org.dfra.river.call.Endpoints;
import org.dfra.river.call.JeriExporters;
import org.dfra.river.call.ResurrectingExporter;
import org.jspecify.annotations.Nullable;

/**
 * Exporters for module servers, for use in a module's Jini configuration:
 *
 * <pre>
 *   org.dfra.river.server {
 *       serverExporter = Exporters.jeri((ServerSettings) $data, 2000L);
 *   }
 * </pre>
 */
public final class Exporters {

  private Exporters() {}

  /**
   * JERI over TCP on a port that the system chooses. Calls have a deadline, and the proxy
   * reactivates an activatable server that does not run.
   *
   * @param deadlineMillis the longest wait for an answer, in milliseconds, at least 1
   */
  public static Exporter jeri(ServerSettings settings, long deadlineMillis) {
    Exporter plain = jeri(settings.host(), deadlineMillis);
    return settings.id() == null ? plain : new ResurrectingExporter(settings.id(), plain);
  }

  /** As {@link #jeri(ServerSettings, long)}, over River's own transport. */
  public static Exporter river(ServerSettings settings, long deadlineMillis) {
    Exporter plain =
        JeriExporters.keepingAlive(
            Endpoints.river(settings.host(), 0), new DeadlineILFactory(deadlineMillis));
    return settings.id() == null ? plain : new ResurrectingExporter(settings.id(), plain);
  }

  /** JERI over TCP, as above, for an object that is not activatable. */
  public static Exporter jeri(String host, long deadlineMillis) {
    return JeriExporters.keepingAlive(
        Endpoints.tcp(host, 0), new DeadlineILFactory(deadlineMillis));
  }

  /**
   * JRMP, the protocol of plain Java RMI, instead of JERI, for clients that support nothing else.
   * It listens on one address; the deadline limits each read. The proxy of an activatable server
   * reactivates it. A client with filters reads the proxy only if {@code -Ddfra.serial.jrmp=true}
   * is set.
   *
   * @param deadlineMillis the longest wait for an answer, in milliseconds, at least 1
   */
  public static Exporter jrmp(ServerSettings settings, long deadlineMillis) {
    EncryptedExport.require("JRMP");
    JrmpSocketFactory sockets =
        new JrmpSocketFactory(settings.host(), Math.toIntExact(deadlineMillis));
    Exporter plain = new JrmpCallsExporter(new JrmpExporter(0, sockets, sockets), settings.host());
    return settings.id() == null ? plain : new ResurrectingExporter(settings.id(), plain);
  }

  /**
   * The {@code $data} of a module's Jini configuration.
   *
   * @param id the server's activation ID, or null if no activation system created it
   * @param host address or name in its proxies
   */
  public record ServerSettings(@Nullable ActivationID id, String host) {}
}
