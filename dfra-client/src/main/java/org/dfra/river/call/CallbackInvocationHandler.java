package org.dfra.river.call;

import java.io.IOException;
import java.io.InvalidObjectException;
import java.io.NotSerializableException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.lang.reflect.Method;
import java.time.Duration;
import java.util.Collection;
import net.jini.core.constraint.MethodConstraints;
import net.jini.jeri.BasicInvocationHandler;
import net.jini.jeri.BasicObjectEndpoint;
import net.jini.jeri.ObjectEndpoint;
import net.jini.jeri.OutboundRequest;
import net.jini.jeri.tcp.TcpEndpoint;
import org.dfra.river.filter.SerialFilters;
import org.dfra.river.transport.AbortableEndpoint;
import org.dfra.river.transport.CallInFlight;
import org.dfra.river.transport.CallWatchdog;
import org.jspecify.annotations.Nullable;

/**
 * Calls back an object of another process, on the thread of the caller and under a deadline of this
 * computer.
 *
 * <p>Unlike {@link DeadlineInvocationHandler} it needs no second thread, whatever the transport: at
 * the deadline the watchdog aborts the request, or closes the connection that is still being
 * established, and the caller's thread is released. So at most one thread per caller waits, and a
 * pool of callers bounds both.
 */
final class CallbackInvocationHandler extends BasicInvocationHandler {

  private static final long serialVersionUID = 1L;

  private final long deadlineMillis;

  /**
   * @param deadline timeout of a call, at least a millisecond
   */
  CallbackInvocationHandler(
      ObjectEndpoint endpoint, @Nullable MethodConstraints server, Duration deadline) {
    super(endpoint, server);
    this.deadlineMillis = deadline.toMillis();
    if (deadlineMillis < 1) {
      throw new IllegalArgumentException("deadline " + deadline + " is shorter than 1 ms");
    }
  }

  /**
   * As the other constructor, with other client constraints; JERI's base class requires this form.
   */
  public CallbackInvocationHandler(
      CallbackInvocationHandler other, @Nullable MethodConstraints client) {
    super(other, client);
    this.deadlineMillis = other.deadlineMillis;
  }

  @Override
  public @Nullable Object invoke(Object proxy, Method method, Object @Nullable [] args)
      throws Throwable {
    if (method.getDeclaringClass() == Object.class) {
      return super.invoke(proxy, method, args);
    }
    CallInFlight call = new CallInFlight(true);
    CallWatchdog.watch(call, deadlineMillis, deadlineMillis);
    try {
      return call.<@Nullable Object>runAsCurrent(() -> super.invoke(proxy, method, args));
    } catch (Throwable e) { // as InvocationHandler declares it
      throw call.isAbandoned() ? exceeded(call, method, e) : e;
    } finally {
      CallWatchdog.release(call);
      boolean unused = call.finish();
    }
  }

  private DeadlineExceededException exceeded(CallInFlight call, Method method, Throwable cause) {
    String called =
        method.getDeclaringClass().getSimpleName() + "." + method.getName() + " on " + peerName();
    DeadlineExceededException exceeded =
        new DeadlineExceededException(called, Duration.ofMillis(deadlineMillis), call.mayHaveRun());
    exceeded.detail = cause; // a RemoteException does not accept a cause by initCause
    if (getObjectEndpoint() instanceof BasicObjectEndpoint basic) {
      if (basic.getEndpoint() instanceof AbortableEndpoint endpoint) {
        endpoint.closeIdleConnections();
      } else if (basic.getEndpoint() instanceof TcpEndpoint server) {
        PeerSockets.probe(server);
      }
    }
    return exceeded;
  }

  private String peerName() {
    ObjectEndpoint endpoint = getObjectEndpoint();
    return DeadlineInvocationHandler.name(
        endpoint instanceof BasicObjectEndpoint basic ? basic.getEndpoint() : endpoint);
  }

  @Override
  @SuppressWarnings("rawtypes") // as River declares it
  protected ObjectOutputStream createMarshalOutputStream(
      Object proxy, Method method, OutboundRequest request, Collection context) throws IOException {
    return super.createMarshalOutputStream(
        proxy, method, CallInFlight.attachRequest(request), context);
  }

  /** Filters the result before it is deserialized. */
  @Override
  @SuppressWarnings("rawtypes") // as River declares it
  protected ObjectInputStream createMarshalInputStream(
      Object proxy, Method method, OutboundRequest request, boolean integrity, Collection context)
      throws IOException {
    return SerialFilters.openResult(
        request,
        method,
        bounded -> super.createMarshalInputStream(proxy, method, bounded, integrity, context));
  }

  private void writeObject(ObjectOutputStream out) throws IOException {
    throw new NotSerializableException(
        CallbackInvocationHandler.class.getName()
            + " stays in the virtual machine that calls back");
  }

  private void readObject(ObjectInputStream in) throws IOException {
    throw new InvalidObjectException(CallbackInvocationHandler.class.getName() + " is never sent");
  }
}
