package org.dfra.river.call;

import java.io.IOException;
import java.io.InterruptedIOException;
import java.io.InvalidObjectException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Method;
import java.nio.channels.ClosedByInterruptException;
import java.rmi.RemoteException;
import java.rmi.activation.Activator;
import java.time.Duration;
import java.util.Collection;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import net.jini.core.constraint.MethodConstraints;
import net.jini.core.constraint.RemoteMethodControl;
import net.jini.jeri.BasicInvocationHandler;
import net.jini.jeri.BasicObjectEndpoint;
import net.jini.jeri.ObjectEndpoint;
import net.jini.jeri.OutboundRequest;
import net.jini.jeri.tcp.TcpEndpoint;
import net.jini.security.proxytrust.TrustEquivalence;
import org.dfra.module.StopsRobot;
import org.dfra.river.access.CallCredential;
import org.dfra.river.access.CredentialPeer;
import org.dfra.river.filter.SerialFilters;
import org.dfra.river.filter.SerialLimits;
import org.dfra.river.identity.CurrentIdentity;
import org.dfra.river.transport.AbortableEndpoint;
import org.dfra.river.transport.CallInFlight;
import org.dfra.river.transport.CallWatchdog;
import org.jspecify.annotations.Nullable;

/**
 * Gives every remote call a deadline.
 *
 * <p>JERI waits for a response without limit, and a peer that was suspended or left radio range
 * does not close its socket. Here the caller continues when the deadline has passed, wherever the
 * call is blocked, and learns whether the call may have run. If the deadline is longer than usual,
 * connecting to the peer still has the usual deadline.
 *
 * <p>The deadline is sent with the proxy. A proxy that was received waits for a response at most
 * {@value #MAX_DEADLINE_MILLIS} ms, or {@value #MAX_ACTIVATION_DEADLINE_MILLIS} ms for the
 * activation system, whatever its own deadline.
 */
public final class DeadlineInvocationHandler extends BasicInvocationHandler {

  private static final long serialVersionUID = 1L;

  private static final UnresponsivePeers UNRESPONSIVE = new UnresponsivePeers();

  /**
   * The deadline of the connection. A proxy with a longer deadline for the response, such as that
   * of an activator that starts a virtual machine, has no more time to connect.
   */
  private static final long CONNECTED_MILLIS = DeadlineILFactory.DEFAULT_DEADLINE.toMillis();

  /**
   * The longest deadline, in milliseconds, of a received proxy: its sender chose the deadline, but
   * the waiting threads belong to this computer.
   */
  static final long MAX_DEADLINE_MILLIS = 10_000;

  /** The longest deadline for calls of the activation system, which start virtual machines. */
  static final long MAX_ACTIVATION_DEADLINE_MILLIS = 30_000;

  /** The timeout of a call, in milliseconds. */
  private long deadlineMillis;

  /** The maximum size of a response; null for the default. It is not sent with the proxy. */
  private final transient @Nullable SerialLimits answerLimits;

  /** Whether it was deserialized. */
  private transient boolean isRead;

  /**
   * @param deadline timeout of a call, at least a millisecond
   */
  DeadlineInvocationHandler(
      ObjectEndpoint endpoint, @Nullable MethodConstraints server, Duration deadline) {
    this(endpoint, server, deadline, null);
  }

  /**
   * @param deadline timeout of a call, at least a millisecond
   * @param answerLimits maximum size of a response; null for the default
   */
  DeadlineInvocationHandler(
      ObjectEndpoint endpoint,
      @Nullable MethodConstraints server,
      Duration deadline,
      @Nullable SerialLimits answerLimits) {
    super(endpoint, server);
    this.answerLimits = answerLimits;
    this.deadlineMillis = deadline.toMillis();
    if (deadlineMillis < 1) {
      throw new IllegalArgumentException("deadline " + deadline + " is shorter than 1 ms");
    }
  }

  /**
   * As the other constructor, with other client constraints; JERI's base class requires this form.
   */
  public DeadlineInvocationHandler(
      DeadlineInvocationHandler other, @Nullable MethodConstraints client) {
    super(other, client);
    this.answerLimits = other.answerLimits;
    this.deadlineMillis = other.deadlineMillis;
    this.isRead = other.isRead;
  }

  @Override
  protected InvocationHandler setClientConstraints(@Nullable MethodConstraints constraints) {
    return new DeadlineInvocationHandler(this, constraints);
  }

  @Override
  public @Nullable Object invoke(Object proxy, Method method, Object @Nullable [] args)
      throws Throwable {
    Class<?> declarer = method.getDeclaringClass();
    if (declarer == Object.class
        || declarer == RemoteMethodControl.class
        || declarer == TrustEquivalence.class) {
      return super.invoke(proxy, method, args);
    }
    Object peer = peer();
    if (peer instanceof AbortableEndpoint endpoint) {
      // What the answer contains belongs to the same identity: robots may share a virtual machine.
      return CurrentIdentity.callWith(
          endpoint.identity(), () -> invokeHere(endpoint, proxy, method, args));
    }
    int held = UNRESPONSIVE.blockedThreads(peer);
    if (held >= UnresponsivePeers.MAX_BLOCKED_THREADS) {
      throw new DeadlineExceededException(
          describe(method) + " was not tried: " + held + " calls to " + name(peer) + " still hang");
    }
    CallInFlight call = new CallInFlight();
    FutureTask<@Nullable Object> answer =
        new FutureTask<>(() -> carry(call, peer, proxy, method, args));
    CallThreads.run(answer);
    return await(answer, call, peer, method);
  }

  /** Calls on the caller's own thread: closing a connection of this transport always frees it. */
  private @Nullable Object invokeHere(
      AbortableEndpoint endpoint, Object proxy, Method method, Object @Nullable [] args)
      throws Throwable {
    long deadline = deadlineMillis(method);
    CallInFlight call = CallInFlight.closing(method.isAnnotationPresent(StopsRobot.class));
    CallWatchdog.watch(call, CONNECTED_MILLIS, deadline);
    try {
      return call.<@Nullable Object>runAsCurrent(() -> super.invoke(proxy, method, args));
    } catch (Throwable e) { // as InvocationHandler declares it
      if (call.isAbandoned()) {
        endpoint.closeIdleConnections(); // they may be as dead
        long awaited = call.hasRequest() ? deadline : Math.min(deadline, CONNECTED_MILLIS);
        DeadlineExceededException exceeded =
            new DeadlineExceededException(
                describe(method), Duration.ofMillis(awaited), call.mayHaveRun());
        exceeded.addSuppressed(e); // how the connection ended says nothing to the user
        throw exceeded;
      }
      if (Thread.currentThread().isInterrupted() && isInterruption(e)) { // not the server's words
        CallInterruptedException interrupted =
            new CallInterruptedException(describe(method), call.mayHaveRun());
        interrupted.addSuppressed(e);
        throw interrupted;
      }
      throw e;
    } finally {
      CallWatchdog.release(call);
      boolean unused = call.finish();
    }
  }

  /** Whether the caller's interruption has ended the call: it closes the connection. */
  private static boolean isInterruption(Throwable failure) {
    @Nullable Throwable at = failure instanceof RemoteException ? failure : null;
    while (at != null) {
      if (at instanceof ClosedByInterruptException || at instanceof InterruptedIOException) {
        return true;
      }
      at = at.getCause();
    }
    return false;
  }

  /** The timeout of a call of a method, in milliseconds. */
  long deadlineMillis(Method method) {
    boolean startsProcesses =
        method.getDeclaringClass().getPackageName().equals(Activator.class.getPackageName());
    return isRead && !startsProcesses
        ? Math.min(deadlineMillis, MAX_DEADLINE_MILLIS)
        : deadlineMillis;
  }

  private @Nullable Object await(
      FutureTask<@Nullable Object> answer, CallInFlight call, Object peer, Method method)
      throws Throwable {
    long deadline = deadlineMillis(method);
    try {
      return answer(answer, call, deadline);
    } catch (ExecutionException e) {
      Throwable cause = e.getCause();
      throw cause instanceof Carried carried ? carried.getCause() : cause;
    } catch (TimeoutException e) {
      long awaited = call.hasRequest() ? deadline : Math.min(deadline, CONNECTED_MILLIS);
      boolean mayHaveRun = giveUp(call, peer);
      if (peer instanceof TcpEndpoint server) {
        PeerSockets.probeAsync(server);
      }
      throw new DeadlineExceededException(describe(method), Duration.ofMillis(awaited), mayHaveRun);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      boolean mayHaveRun = giveUp(call, peer);
      throw new CallInterruptedException(describe(method), mayHaveRun);
    }
  }

  private @Nullable Object answer(
      FutureTask<@Nullable Object> answer, CallInFlight call, long deadline)
      throws ExecutionException, TimeoutException, InterruptedException {
    long rest = deadline;
    if (rest > CONNECTED_MILLIS) {
      try {
        return answer.get(CONNECTED_MILLIS, TimeUnit.MILLISECONDS);
      } catch (TimeoutException e) {
        if (!call.hasRequest()) {
          throw e;
        }
        rest -= CONNECTED_MILLIS;
      }
    }
    return answer.get(rest, TimeUnit.MILLISECONDS);
  }

  /**
   * Abandons a call. Returns whether it may have run, which is final because nothing more of it can
   * be sent.
   */
  private static boolean giveUp(CallInFlight call, Object peer) {
    UNRESPONSIVE.addBlockedThread(peer);
    if (!call.abandon()) {
      UNRESPONSIVE.removeBlockedThread(peer);
    }
    return call.mayHaveRun();
  }

  private @Nullable Object carry(
      CallInFlight call, Object peer, Object proxy, Method method, Object @Nullable [] args)
      throws Exception {
    try {
      return call.<@Nullable Object>runAsCurrent(() -> super.invoke(proxy, method, args));
    } catch (Exception | Error e) {
      throw e;
    } catch (Throwable e) { // as InvocationHandler declares it
      throw new Carried(e);
    } finally {
      if (call.finish()) {
        UNRESPONSIVE.removeBlockedThread(peer);
      }
    }
  }

  /** The peer of the connection gets into the context, for {@link #marshalMethod}. */
  @Override
  @SuppressWarnings("rawtypes") // as River declares it
  protected ObjectOutputStream createMarshalOutputStream(
      Object proxy, Method method, OutboundRequest request, Collection context) throws IOException {
    request.populateContext(context);
    return super.createMarshalOutputStream(
        proxy, method, CallInFlight.attachRequest(request), context);
  }

  /** Also writes the credential that the call carries, if it has one. */
  @Override
  @SuppressWarnings("rawtypes") // as River declares it
  protected void marshalMethod(
      Object proxy, Method method, ObjectOutputStream out, Collection context) throws IOException {
    for (Object each : context) {
      if (each instanceof CredentialPeer peer) {
        byte @Nullable [] credential = peer.credentialFor(method);
        if (credential != null) {
          CallCredential.write(credential, out);
        }
      }
    }
    super.marshalMethod(proxy, method, out, context);
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
        answerLimits == null ? SerialFilters.resultLimits() : answerLimits,
        bounded -> super.createMarshalInputStream(proxy, method, bounded, integrity, context));
  }

  private Object peer() {
    ObjectEndpoint endpoint = getObjectEndpoint();
    return endpoint instanceof BasicObjectEndpoint basic ? basic.getEndpoint() : endpoint;
  }

  /** A peer's address, for messages. */
  static String name(Object peer) {
    @Nullable PeerAddress address = PeerAddress.ofEndpoint(peer);
    return address == null ? peer.toString() : address.host() + ":" + address.port();
  }

  private String describe(Method method) {
    return method.getDeclaringClass().getSimpleName()
        + "."
        + method.getName()
        + " on "
        + name(peer());
  }

  @Override
  public boolean equals(@Nullable Object other) {
    return super.equals(other)
        && other instanceof DeadlineInvocationHandler handler
        && handler.deadlineMillis == deadlineMillis;
  }

  @Override
  public int hashCode() {
    return super.hashCode();
  }

  private void readObject(ObjectInputStream in) throws IOException, ClassNotFoundException {
    in.defaultReadObject();
    if (deadlineMillis < 1) {
      throw new InvalidObjectException("deadline of " + deadlineMillis + " ms");
    }
    deadlineMillis = Math.min(deadlineMillis, MAX_ACTIVATION_DEADLINE_MILLIS);
    isRead = true;
  }

  /** Carries a throwable that is neither exception nor error across the thread. */
  private static final class Carried extends Exception {
    private static final long serialVersionUID = 1L;

    Carried(Throwable cause) {
      super(cause);
    }

    @Override
    public synchronized Throwable getCause() {
      return java.util.Objects.requireNonNull(super.getCause());
    }
  }
}
