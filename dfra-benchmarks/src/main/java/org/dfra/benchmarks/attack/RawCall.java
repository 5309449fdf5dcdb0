package org.dfra.benchmarks.attack;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.ObjectInputStream;
import java.io.OutputStream;
import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Proxy;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import net.jini.core.constraint.InvocationConstraints;
import net.jini.io.MarshalInputStream;
import net.jini.jeri.BasicInvocationHandler;
import net.jini.jeri.BasicObjectEndpoint;
import net.jini.jeri.ObjectEndpoint;
import net.jini.jeri.OutboundRequest;
import net.jini.jeri.OutboundRequestIterator;
import org.dfra.river.call.ResurrectingHandler;
import org.dfra.river.identity.CurrentIdentity;
import org.dfra.river.transport.AbortableEndpoint;
import org.dfra.river.transport.SourceBoundEndpoint;
import org.jspecify.annotations.Nullable;

/**
 * One JERI request whose bytes the caller writes: complete, truncated, or left unfinished while
 * this is open.
 *
 * <pre>{@code
 * try (RawCall call = RawCall.to(proxy)) {
 *   call.send(CallBytes.of(method, argument));
 *   RawCall.Answer answer = call.finish(Duration.ofSeconds(2));
 * }
 * }</pre>
 *
 * <p>Not thread-safe.
 */
public final class RawCall implements AutoCloseable {

  private static final int RETURN = 1;
  private static final int THROW = 2;

  private final ObjectEndpoint target;
  private final OutboundRequest request;

  private RawCall(ObjectEndpoint target, OutboundRequest request) {
    this.target = target;
    this.request = request;
  }

  /** How a request ended. */
  public enum Status {
    /** The method returned; its result follows. */
    RETURNED,
    /** An exception follows: the method's, or the refusal of the server's invocation layer. */
    THREW,
    /** The server does not know this version of the invocation protocol. */
    MISMATCH,
    /** The server has no such object. */
    NO_SUCH_OBJECT,
    /** The server or its transport ended the request without an answer. */
    ABORTED,
    /** No answer within the timeout; the request was aborted. */
    SILENT
  }

  /**
   * The response.
   *
   * @param status how the request ended
   * @param bytes the object stream after the status
   * @param failure why there is no response; null if there is one
   */
  public record Answer(Status status, byte[] bytes, @Nullable IOException failure) {

    /** Reads the result or the exception, for results that are not objects. */
    public ObjectInputStream stream() throws IOException {
      return new MarshalInputStream(
          new ByteArrayInputStream(bytes), RawCall.class.getClassLoader(), false, null, List.of());
    }

    /**
     * The result or the exception.
     *
     * @throws IOException if it cannot be read, or there is none
     */
    public Object object() throws IOException {
      try (ObjectInputStream in = stream()) {
        return in.readObject();
      } catch (ClassNotFoundException e) {
        throw new IOException("the answer has a class that is not known here", e);
      }
    }
  }

  /**
   * Opens a request to the object of a proxy.
   *
   * @param proxy a stock JERI proxy, one of DFRA's, or one that reactivates its object
   * @throws IOException if it cannot connect to the server
   * @throws IllegalArgumentException if it is not such a proxy
   */
  public static RawCall to(Object proxy) throws IOException {
    return to(endpoint(proxy));
  }

  /**
   * Opens a request to an object.
   *
   * @throws IOException if it cannot connect to the server
   */
  public static RawCall to(ObjectEndpoint object) throws IOException {
    ObjectEndpoint target = unbuffered(object);
    OutboundRequestIterator attempts = target.newCall(InvocationConstraints.EMPTY);
    while (true) {
      try {
        return new RawCall(target, attempts.next());
      } catch (IOException e) {
        if (!attempts.hasNext()) { // a pooled connection may have ended
          throw e;
        }
      }
    }
  }

  /**
   * DFRA's own transport sends only complete blocks. A member of a team has no other, since the one
   * that sends at once does not encrypt.
   */
  private static ObjectEndpoint unbuffered(ObjectEndpoint target) {
    if (CurrentIdentity.get() == null
        && target instanceof BasicObjectEndpoint object
        && object.getEndpoint() instanceof AbortableEndpoint endpoint) {
      @Nullable String source =
          endpoint instanceof SourceBoundEndpoint bound ? bound.source() : null;
      return new BasicObjectEndpoint(
          new UnbufferedEndpoint(endpoint.host(), endpoint.port(), source),
          object.getObjectIdentifier(),
          false);
    }
    return target;
  }

  /**
   * The endpoint and the identity of a proxy's object.
   *
   * @throws IllegalArgumentException if it is not a JERI proxy
   */
  public static ObjectEndpoint endpoint(@Nullable Object proxy) {
    if (proxy != null && Proxy.isProxyClass(proxy.getClass())) {
      InvocationHandler handler = Proxy.getInvocationHandler(proxy);
      if (handler instanceof ResurrectingHandler resurrecting) {
        return endpoint(resurrecting.live());
      }
      if (handler instanceof BasicInvocationHandler basic) {
        return basic.getObjectEndpoint();
      }
    }
    throw new IllegalArgumentException(
        "no JERI proxy: "
            + (proxy == null ? "null" : proxy.getClass().getName())
            + "; take the remote proxy out of a smart one with Rebased.remote");
  }

  /**
   * Sends bytes now, without finishing the request.
   *
   * @throws IOException if the server ended the request
   */
  public RawCall send(byte[] bytes) throws IOException {
    return send(bytes, bytes.length);
  }

  /**
   * Sends the first {@code length} of these bytes now, without finishing the request.
   *
   * @param length number of bytes
   * @throws IOException if the server ended the request
   */
  public RawCall send(byte[] bytes, int length) throws IOException {
    OutputStream out = request.getRequestOutputStream();
    out.write(bytes, 0, length);
    out.flush();
    return this;
  }

  /**
   * Finishes the request and waits for the response.
   *
   * @param patience timeout, after which the request is aborted
   * @throws InterruptedException if this thread is interrupted while it waits
   */
  public Answer finish(Duration patience) throws InterruptedException {
    FutureTask<Answer> reading = new FutureTask<>(this::read);
    Thread reader = new Thread(reading, "answer to a raw call");
    reader.setDaemon(true);
    reader.start();
    try {
      return reading.get(patience.toMillis(), TimeUnit.MILLISECONDS);
    } catch (TimeoutException e) {
      request.abort();
      return without(Status.SILENT, new IOException("no answer within " + patience, e));
    } catch (ExecutionException | CancellationException e) {
      throw new IllegalStateException("a raw call's answer was not read", e);
    }
  }

  private Answer read() {
    try {
      request.getRequestOutputStream().close();
      RemoteException absent = target.executeCall(request);
      if (absent != null) {
        return without(Status.NO_SUCH_OBJECT, absent);
      }
      InputStream in = request.getResponseInputStream();
      int status = in.read();
      byte[] bytes = in.readAllBytes();
      return switch (status) {
        case -1 -> without(Status.ABORTED, new IOException("the response ended without a status"));
        case RETURN -> new Answer(Status.RETURNED, bytes, null);
        case THROW -> new Answer(Status.THREW, bytes, null);
        default -> new Answer(Status.MISMATCH, bytes, null);
      };
    } catch (IOException e) {
      return without(Status.ABORTED, e);
    }
  }

  private static Answer without(Status status, IOException failure) {
    return new Answer(status, new byte[0], failure);
  }

  /** Aborts the request, if it still runs. */
  @Override
  public void close() {
    request.abort();
  }
}
