package org.dfra.river.discovery;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.InvalidObjectException;
import java.io.ObjectInputFilter;
import java.io.ObjectInputFilter.FilterInfo;
import java.io.ObjectInputStream;
import java.io.ObjectStreamClass;
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
import org.dfra.text.PrintableText;
import org.jspecify.annotations.Nullable;

/**
 * Queries a lookup service for its proxy: the client's part of Jini's unicast discovery, version 1,
 * which every lookup service supports.
 *
 * <pre>
 *   client --- int 1 --------------------------------------------------&gt; lookup service
 *          &lt;-- object stream: MarshalledObject, int groups, UTF each ---
 * </pre>
 *
 * <p>Any host may answer, so every part of a response is bounded: it has at most {@value
 * #ANSWER_BYTES} bytes and {@value #GROUPS} groups of {@value #GROUP_CHARACTERS} characters, must
 * arrive before a deadline, and contains one marshalled object and nothing else. The contents of
 * that object are read within {@code SerialLimits.ANSWER} and the classes that may come from the
 * network. As for every proxy, only trusted code is loaded. No array is allocated for a count that
 * the stream merely claims.
 */
public final class UnicastDiscovery {

  /** Maximum size of a response, in bytes. That of a robot's registrar has about 2 kB. */
  static final int ANSWER_BYTES = 64 << 10;

  /** Maximum number of groups of a lookup service. */
  static final int GROUPS = 64;

  /** Maximum length of a group's name, in characters. */
  static final int GROUP_CHARACTERS = 255;

  private static final int VERSION = 1;

  /** Maximum number of addresses of one host to try. */
  private static final int ADDRESSES = 4;

  /** A marshalled object: itself, two arrays, and their descriptors. */
  private static final int REFERENCES = 32;

  private static final int DEPTH = 4;

  /**
   * The response of a lookup service.
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
   * Queries the lookup service at a host; tries the addresses of the host one after the other.
   *
   * @param port its TCP port for unicast discovery
   * @param timeout time limit for each connection, and for the whole response; the time to resolve
   *     a host's name is not included
   * @throws IOException if no response arrives in time, or it is not that of a lookup service; the
   *     message gives the address and the reason
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
   * Queries the lookup service at the other end of a connection. The caller closes it.
   *
   * @param timeout time limit for the whole response
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
    } catch (Exception | LinkageError | AssertionError e) { // the last: River's, malformed objects
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
    ObjectInputStream in = new AnswerStream(new BufferedInputStream(input));
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

  /** Finds no class but those of an answer's own objects, whatever names it contains. */
  private static final class AnswerStream extends ObjectInputStream {

    AnswerStream(InputStream in) throws IOException {
      super(in);
    }

    @Override
    protected Class<?> resolveClass(ObjectStreamClass descriptor) throws IOException {
      return switch (descriptor.getName()) {
        case "java.rmi.MarshalledObject" -> MarshalledObject.class;
        case "[B" -> byte[].class;
        default ->
            throw new InvalidObjectException(
                "the answer contains class " + PrintableText.word(descriptor.getName()));
      };
    }

    @Override
    protected Class<?> resolveProxyClass(String[] interfaces) throws IOException {
      throw new InvalidObjectException("the answer contains a dynamic proxy");
    }
  }

  /** Checks the stream's own objects; the contents of the marshalled object are bytes here. */
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
   * Requires a proxy that stores its identity. A dynamic proxy would ask the remote host for it,
   * which might never answer.
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
