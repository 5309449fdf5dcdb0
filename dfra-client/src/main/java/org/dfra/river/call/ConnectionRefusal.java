package org.dfra.river.call;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.rmi.ConnectIOException;
import org.jspecify.annotations.Nullable;

/**
 * Decides whether a failed connection proves that no process listens at its address. Only the
 * computer of that address can prove it: it refuses the connection (ECONNREFUSED). A timeout, a
 * network outage, and faults of the caller, such as too many open files, prove nothing.
 */
public final class ConnectionRefusal {

  private static final int SAMPLE_MILLIS = 1000;

  /** Java's message for ECONNREFUSED, in English. */
  private static final String ENGLISH = "Connection refused";

  /**
   * The message in the language of this computer: Java takes the text from the operating system.
   */
  private static final String HERE = sample();

  private ConnectionRefusal() {}

  /**
   * Whether no process listens at the address that was called.
   *
   * @param failure the failure of the call, for example a {@link java.rmi.ConnectException}; what a
   *     server reports of its own calls is no proof
   */
  public static boolean isProvenBy(Throwable failure) {
    @Nullable Throwable at = failure;
    while (at instanceof java.rmi.ConnectException || at instanceof ConnectIOException) {
      at = at.getCause();
    }
    return at instanceof java.net.ConnectException connect && isRefused(connect.getMessage());
  }

  /** A {@link java.net.ConnectException} may also be a timeout. */
  private static boolean isRefused(@Nullable String message) {
    return message != null && (message.contains(ENGLISH) || message.contains(HERE));
  }

  /** Provokes a refused connection: to a port that this process holds and does not listen on. */
  private static String sample() {
    try (Socket held = new Socket();
        Socket refused = new Socket()) {
      InetAddress loopback = InetAddress.getLoopbackAddress();
      held.bind(new InetSocketAddress(loopback, 0));
      refused.connect(new InetSocketAddress(loopback, held.getLocalPort()), SAMPLE_MILLIS);
      return ENGLISH; // no connection is possible
    } catch (java.net.ConnectException e) {
      @Nullable String message = e.getMessage();
      return message == null || message.isBlank() ? ENGLISH : message;
    } catch (IOException e) { // for example too many open files
      return ENGLISH;
    }
  }
}
