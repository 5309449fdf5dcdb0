package org.dfra.river.call;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.rmi.ConnectIOException;
import org.jspecify.annotations.Nullable;

/**
 * Decides whether a failed connection proves that nobody listens at its address. Only the computer
 * of that address can say so: it refuses the connection (ECONNREFUSED). A time-out, a network that
 * is down, and whatever fails at the caller, such as too many open files, prove nothing.
 */
public final class ConnectionRefusal {

  private static final int SAMPLE_MILLIS = 1000;

  /** What Java says of ECONNREFUSED, in English. */
  private static final String ENGLISH = "Connection refused";

  /** The same in the language of this computer: Java takes the text from the operating system. */
  private static final String HERE = sample();

  private ConnectionRefusal() {}

  /**
   * Whether nobody listens at the address that was called.
   *
   * @param failure what the call ended with: {@link java.rmi.ConnectException}, say; what a server
   *     reports of calls of its own is no proof
   */
  public static boolean isProvenBy(Throwable failure) {
    @Nullable Throwable at = failure;
    while (at instanceof java.rmi.ConnectException || at instanceof ConnectIOException) {
      at = at.getCause();
    }
    return at instanceof java.net.ConnectException connect && isRefused(connect.getMessage());
  }

  /** A {@link java.net.ConnectException} may also be a time-out. */
  private static boolean isRefused(@Nullable String message) {
    return message != null && (message.contains(ENGLISH) || message.contains(HERE));
  }

  /** Has a connection refused: at a port that this process holds and does not listen on. */
  private static String sample() {
    try (Socket held = new Socket();
        Socket refused = new Socket()) {
      InetAddress loopback = InetAddress.getLoopbackAddress();
      held.bind(new InetSocketAddress(loopback, 0));
      refused.connect(new InetSocketAddress(loopback, held.getLocalPort()), SAMPLE_MILLIS);
      return ENGLISH; // it cannot be connected
    } catch (java.net.ConnectException e) {
      @Nullable String message = e.getMessage();
      return message == null || message.isBlank() ? ENGLISH : message;
    } catch (IOException e) { // too many open files now, say
      return ENGLISH;
    }
  }
}
