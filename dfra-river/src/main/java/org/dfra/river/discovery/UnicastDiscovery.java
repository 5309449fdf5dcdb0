package org.dfra.river.discovery;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InvalidObjectException;
import java.io.ObjectInputFilter;
import java.io.ObjectInputFilter.FilterInfo;
import java.io.ObjectInputStream;
import java.lang.reflect.Proxy;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.rmi.MarshalledObject;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.io.MarshalledInstance;
import org.dfra.river.filter.SerialFilters;
import org.jspecify.annotations.Nullable;

/**
 * Asks a lookup service for its proxy: the client's part of Jini's unicast discovery, version 1,
 * which every lookup service answers.
 *
 * <pre>
 *   client --- int 1 --------------------------------------------------&gt; lookup service
 *          &lt;-- object stream: MarshalledObject, int groups, UTF each ---
 * </pre>
 *
 * <p>Anybody may answer, so nothing is taken for granted: an answer has {@value #ANSWER_BYTES}
 * bytes, {@value #GROUPS} groups of {@value #GROUP_CHARACTERS} characters and a deadline at the
 * most, and holds a marshalled object and nothing else. What that holds is read within {@code
 * SerialLimits.ANSWER} and the classes that may come from the network; code is loaded for it as for
 * every proxy, from trusted code only. No array is made for a count that the stream merely claims.
 */
public final class UnicastDiscovery {

  /** Most bytes of an answer. That of a robot's registrar has about 2 kB. */
  static final int ANSWER_BYTES = 64 << 10;

  /** Most groups of a lookup service. */
  static final int GROUPS = 64;

  /** Most characters of a group's name. */
  static final int GROUP_CHARACTERS = 255;

  private static final int VERSION = 1;

  /** Most addresses of one host that are tried. */
  private static final int ADDRESSES = 4;

  /** A marshalled object: itself, two arrays, and what describes them. */
  private static final int REFERENCES = 32;

  private static final int DEPTH = 4;

  /**
   * What a lookup service answers.
   *
   * @param registrar its proxy, and where it answered
   * @param groups the groups that it is a member of
   */
  public record DiscoveryResponse(LocatedRegistrar registrar, List<String> groups) {

    public DiscoveryResponse {
      groups = List.copyOf(groups);
    }
  }

  private UnicastDiscovery() {}

  /**
   * Asks the lookup service at a host; where the host has several addresses, one after the other.
   *
   * @param port its TCP port for unicast discovery
   * @param timeout how long each connection may take, and how long the whole answer; finding the
   *     addresses of a host that is named comes on top
   * @throws IOException if nobody answers in time, or the answer is none of a lookup service; the
   *     message says where and why
   * @throws ClassNotFoundException if the proxy's class is not here and may not be loaded
   */
  public static DiscoveryResponse discover(String host, int port, Duration timeout)
      throws IOException, ClassNotFoundException {
    @Nullable IOException failure = null;
    InetAddress[] addresses = InetAddress.getAllByName(host);
    for (int i = 0; i < Math.min(ADDRESSES, addresses.length); i++) {
      try (Socket socket = new Socket()) {
        socket.connect(
            new InetSocketAddress(addresses[i], port), Math.toIntExact(timeout.toMillis()));
        return discover(socket, timeout);
      } catch (IOException e) {
        if (failure == null) {
          failure = e;
        } else {
          failure.addSuppressed(e);
        }
      }
    }
    throw failure == null ? new IOException(host + " has no address") : failure;
  }

  /**
   * Asks the lookup service at the other end of a connection. The caller closes it.
   *
   * @param timeout how long the whole answer may take
   * @throws IOException as above
   * @throws ClassNotFoundException as above
   */
  static DiscoveryResponse discover(Socket socket, Duration timeout)
      throws IOException, ClassNotFoundException {
    long end = System.nanoTime() + timeout.toNanos();
    try {
      socket.setTcpNoDelay(true);
      socket.getOutputStream().write(ByteBuffer.allocate(Integer.BYTES).putInt(VERSION).array());
      return SerialFilters.<DiscoveryResponse, Exception>readDiscoveryResponse(
          () -> answer(socket, end));
    } catch (ClassNotFoundException e) {
      throw e;
    } catch (Exception | LinkageError | AssertionError e) { // the last: River's, of odd objects
      throw new IOException(
          "no lookup service answers at "
              + socket.getInetAddress().getHostAddress()
              + ":"
              + socket.getPort()
              + ": "
              + e,
          e);
    }
  }

  private static DiscoveryResponse answer(Socket socket, long end)
      throws IOException, ClassNotFoundException {
    DeadlineInput input = new DeadlineInput(socket, end, ANSWER_BYTES);
    ObjectInputStream in = new ObjectInputStream(new BufferedInputStream(input));
    in.setObjectInputFilter(UnicastDiscovery::check);
    if (!(in.readObject() instanceof MarshalledObject<?> marshalled)) {
      throw new InvalidObjectException("the answer does not begin with a marshalled object");
    }
    int count = in.readInt();
    if (count < 0 || count > GROUPS) {
      throw new InvalidObjectException(
          "a lookup service of " + count + " groups; at most " + GROUPS + " are read");
    }
    List<String> groups = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      String group = in.readUTF();
      if (group.length() > GROUP_CHARACTERS) {
        throw new InvalidObjectException(
            "a group's name of "
                + group.length()
                + " characters; at most "
                + GROUP_CHARACTERS
                + " are read");
      }
      groups.add(group);
    }
    SerialFilters.check(marshalled);
    MarshalledInstance form = new MarshalledInstance(marshalled);
    InetSocketAddress place = new InetSocketAddress(socket.getInetAddress(), socket.getPort());
    return new DiscoveryResponse(
        new LocatedRegistrar(registrar(form.get(false)), form, place), groups);
  }

  /** The stream's own objects; what the marshalled one holds are bytes to it. */
  private static ObjectInputFilter.Status check(FilterInfo info) {
    if (info.depth() > DEPTH
        || info.references() > REFERENCES
        || info.streamBytes() > ANSWER_BYTES
        || info.arrayLength() > ANSWER_BYTES) {
      return ObjectInputFilter.Status.REJECTED;
    }
    Class<?> type = info.serialClass();
    if (type == null) {
      return ObjectInputFilter.Status.UNDECIDED;
    }
    return type == MarshalledObject.class || type == byte[].class
        ? ObjectInputFilter.Status.ALLOWED
        : ObjectInputFilter.Status.REJECTED;
  }

  /**
   * A proxy that knows its identity. A dynamic proxy does not: asked for it, it would call whoever
   * answered, who need never return.
   */
  private static ServiceRegistrar registrar(@Nullable Object proxy) throws InvalidObjectException {
    if (!(proxy instanceof ServiceRegistrar registrar) || Proxy.isProxyClass(proxy.getClass())) {
      throw new InvalidObjectException(
          "what answered is "
              + (proxy == null ? "nothing" : "of class " + proxy.getClass().getName())
              + ", not a lookup service's proxy");
    }
    if (registrar.getServiceID() == null) {
      throw new InvalidObjectException("a lookup service without an identity");
    }
    return registrar;
  }
}
