package org.dfra.river.call;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.awaitility.Awaitility.await;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.io.Serializable;
import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.rmi.ConnectException;
import java.rmi.ConnectIOException;
import java.rmi.MarshalException;
import java.rmi.NoSuchObjectException;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.UnknownHostException;
import java.rmi.UnmarshalException;
import java.rmi.activation.ActivateFailedException;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationID;
import java.rmi.activation.UnknownObjectException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import net.jini.constraint.BasicMethodConstraints;
import net.jini.core.constraint.Integrity;
import net.jini.core.constraint.InvocationConstraint;
import net.jini.core.constraint.InvocationConstraints;
import net.jini.core.constraint.MethodConstraints;
import net.jini.core.constraint.RemoteMethodControl;
import net.jini.security.proxytrust.TrustEquivalence;
import org.dfra.module.Idempotent;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** What a proxy does when its object is dead, and what it must not do. */
class ResurrectingHandlerTest {

  /** What is served here. */
  public interface Service extends Remote {
    @Idempotent
    String read() throws RemoteException;

    String change() throws RemoteException;
  }

  /** A live proxy that fails as it is told, and then answers with its name. */
  private static final class Live implements InvocationHandler, Serializable {
    private static final long serialVersionUID = 1L;
    final String name;
    private final List<Throwable> failures;
    private final MethodConstraints constraints;
    private AtomicInteger calls = new AtomicInteger();

    Live(String name, MethodConstraints constraints, Throwable... failures) {
      this.name = name;
      this.constraints = constraints;
      this.failures = new ArrayList<>(Arrays.asList(failures));
    }

    /** How often it was called, under whatever constraints. */
    int calls() {
      return calls.get();
    }

    @Override
    public synchronized Object invoke(Object proxy, Method method, Object[] args) throws Throwable {
      switch (method.getName()) {
        case "equals":
          return Proxy.isProxyClass(args[0].getClass())
              && Proxy.getInvocationHandler(args[0]) instanceof Live other
              && other.name.equals(name);
        case "hashCode":
          return name.hashCode();
        case "toString":
          return name;
        case "setConstraints":
          Live constrained = new Live(name, (MethodConstraints) args[0]);
          constrained.failures.addAll(failures);
          constrained.calls = calls;
          return proxyOf(constrained);
        case "getConstraints":
          return constraints;
        default:
          calls.incrementAndGet();
          if (!failures.isEmpty()) {
            throw failures.remove(0);
          }
          return name + (constraints == null ? "" : " constrained");
      }
    }
  }

  private static Remote live(String name, Throwable... failures) {
    return proxyOf(new Live(name, null, failures));
  }

  private static Remote proxyOf(Live live) {
    return (Remote)
        Proxy.newProxyInstance(
            Service.class.getClassLoader(),
            new Class<?>[] {Service.class, RemoteMethodControl.class},
            live);
  }

  /** Says what the activator does. */
  private interface Activating {
    Remote activate(boolean force) throws ActivationException, RemoteException;
  }

  /** An ID whose activation is the test's. */
  private static final class Id extends ActivationID implements TrustEquivalence {
    private static final long serialVersionUID = 1L;
    final String name;
    final transient List<Boolean> asked = Collections.synchronizedList(new ArrayList<>());
    transient volatile Activating activating =
        force -> {
          throw new AssertionError("not to be activated");
        };

    Id(String name) {
      super(null);
      this.name = name;
    }

    @Override
    public Remote activate(boolean force) throws ActivationException, RemoteException {
      asked.add(force);
      return activating.activate(force);
    }

    void bringsBack(Remote... lives) {
      List<Remote> left = new ArrayList<>(Arrays.asList(lives));
      activating = force -> ResurrectingExporter.proxy(this, left.remove(0));
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof Id id && id.name.equals(name);
    }

    @Override
    public int hashCode() {
      return name.hashCode();
    }

    @Override
    public boolean checkTrustEquivalence(Object other) {
      return equals(other);
    }

    private Object writeReplace() {
      return new Form(name);
    }

    private record Form(String name) implements Serializable {
      private Object readResolve() {
        return new Id(name);
      }
    }
  }

  private final Id id = new Id("object");
  private final ExecutorService threads = Executors.newCachedThreadPool();

  @AfterEach
  void end() {
    threads.shutdownNow();
  }

  private Service proxy(Remote live) {
    return (Service) ResurrectingExporter.proxy(id, live);
  }

  @Test
  void livingObjectIsCalledAndNobodyElseIsAsked() throws Exception {
    assertThat(proxy(live("alive")).read()).isEqualTo("alive");
    assertThat(id.asked).isEmpty();
  }

  @Test
  void objectThatIsCertainlyNotThereIsBroughtBackAndForcedTheSecondTime() throws Exception {
    for (RemoteException dead :
        List.of(
            new NoSuchObjectException("x"),
            new ConnectException("x"),
            new ConnectIOException("x"),
            new UnknownHostException("x"))) {
      id.asked.clear();
      id.bringsBack(live("dead too", dead), live("new"));
      assertThat(proxy(live("dead", dead)).change()).as("%s", dead).isEqualTo("new");
      assertThat(id.asked).as("force, %s", dead).containsExactly(false, true);
    }
  }

  @Test
  void thirdFailureReachesTheCaller() {
    ConnectException last = new ConnectException("third");
    id.bringsBack(live("b", new ConnectException("second")), live("c", last));
    assertThatExceptionOfType(ConnectException.class)
        .isThrownBy(() -> proxy(live("a", new ConnectException("first"))).read())
        .isSameAs(last);
    assertThat(id.asked).hasSize(2);
  }

  @Test
  void callThatBrokeOffIsRepeatedOnceIfThatDoesNoHarm() throws Exception {
    id.bringsBack(live("new"));
    assertThat(proxy(live("dying", new UnmarshalException("cut"))).read()).isEqualTo("new");

    id.bringsBack(live("dying too", new UnmarshalException("cut again")));
    assertThatExceptionOfType(UnmarshalException.class)
        .isThrownBy(() -> proxy(live("dying", new UnmarshalException("cut"))).read())
        .withMessage("cut again");
  }

  @Test
  void callThatBrokeOffIsNotRepeatedOtherwiseAndTheNextOneAsksAnew() throws Exception {
    Service service = proxy(live("dying", new UnmarshalException("cut")));
    assertThatExceptionOfType(UnmarshalException.class).isThrownBy(service::change);
    assertThat(id.asked).isEmpty();
    id.bringsBack(live("new"));
    assertThat(service.change()).isEqualTo("new");
    assertThat(id.asked).containsExactly(false);
  }

  @Test
  void callThatMetItsDeadlineOrWasInterruptedIsNeverRepeated() throws Exception {
    for (RemoteException end :
        List.of(
            new DeadlineExceededException("late"),
            new CallInterruptedException("read", true),
            new MarshalException("too big"))) {
      Service service = proxy(live("alive", end));
      assertThatExceptionOfType(end.getClass()).isThrownBy(service::read).isSameAs(end);
      assertThat(id.asked).as("activations after %s", end).isEmpty();
    }
  }

  @Test
  void callersThatShareAProxyShareOneActivation() throws Exception {
    CountDownLatch answer = new CountDownLatch(1);
    id.activating =
        force -> {
          await("answer").until(() -> answer.getCount() == 0);
          return ResurrectingExporter.proxy(id, live("new"));
        };
    Service service = proxy(gone());
    List<Future<String>> callers = new ArrayList<>();
    for (int i = 0; i < 32; i++) {
      callers.add(threads.submit(service::read));
    }
    await("the activator is asked").until(() -> !id.asked.isEmpty());
    answer.countDown();
    for (Future<String> each : callers) {
      assertThat(each.get()).isEqualTo("new");
    }
    assertThat(id.asked).as("activations for 32 callers").hasSize(1);
  }

  /** A live proxy that has just been forgotten, so that the first call must activate. */
  private static Remote gone() {
    return live(
        "gone", Collections.nCopies(64, new ConnectException("gone")).toArray(Throwable[]::new));
  }

  @Test
  void interruptedCallerSpoilsNothingForTheOthers() throws Exception {
    CountDownLatch answer = new CountDownLatch(1);
    id.activating =
        force -> {
          try {
            answer.await();
          } catch (InterruptedException e) {
            throw new RemoteException("the shared activation was interrupted", e);
          }
          return ResurrectingExporter.proxy(id, live("new"));
        };
    Service service = proxy(gone());
    AtomicReference<Exception> first = new AtomicReference<>();
    Thread impatient =
        new Thread(
            () -> {
              try {
                service.read();
              } catch (RemoteException e) {
                first.set(e);
              }
            });
    impatient.start();
    await("the activator is asked").until(() -> !id.asked.isEmpty());
    Future<String> patient = threads.submit(service::read);
    impatient.interrupt();
    impatient.join(5000);
    assertThat(first.get()).isInstanceOf(CallInterruptedException.class);
    answer.countDown();
    assertThat(patient.get()).isEqualTo("new");
    assertThat(id.asked).hasSize(1);
  }

  @Test
  void callerThatNeedsForceIsNotPutOffWithAnActivationWithoutIt() throws Exception {
    ConnectException dead = new ConnectException("dead");
    CountDownLatch unforced = new CountDownLatch(1);
    CountDownLatch slow = new CountDownLatch(1);
    id.activating =
        force -> {
          if (force) {
            return ResurrectingExporter.proxy(id, live("new"));
          }
          if (unforced.getCount() == 0) {
            return ResurrectingExporter.proxy(id, live("stale", dead, dead, dead));
          }
          unforced.countDown();
          await("release").until(() -> slow.getCount() == 0);
          return ResurrectingExporter.proxy(id, live("stale", dead, dead, dead));
        };
    Service service = proxy(live("stale", dead, dead, dead, dead));
    Future<String> first = threads.submit(service::read);
    unforced.await();
    Future<String> second = threads.submit(service::read);
    slow.countDown();
    assertThat(first.get()).isEqualTo("new");
    assertThat(second.get()).isEqualTo("new");
  }

  @Test
  void whatTheActivatorSaysIsToldInTheTermsOfACall() {
    Service service = proxy(gone());
    id.activating =
        force -> {
          throw new UnknownObjectException("unregistered");
        };
    assertThatExceptionOfType(NoSuchObjectException.class)
        .isThrownBy(service::read)
        .withCauseInstanceOf(UnknownObjectException.class);
    id.activating =
        force -> {
          throw new ActivationException("its constructor failed");
        };
    assertThatExceptionOfType(ActivateFailedException.class)
        .isThrownBy(service::read)
        .withStackTraceContaining("its constructor failed");
    id.activating =
        force -> {
          throw new ConnectException("nobody there");
        };
    assertThatExceptionOfType(ConnectException.class)
        .isThrownBy(service::read)
        .withMessageContaining("the activation system cannot be reached");
    id.activating =
        force -> {
          throw new DeadlineExceededException("no answer");
        };
    assertThatExceptionOfType(ConnectIOException.class)
        .isThrownBy(service::read)
        .withMessageContaining("the activation system did not answer");
  }

  private void activatorIsOutOfReach() {
    id.activating =
        force -> {
          throw new ConnectException("nobody there");
        };
  }

  @Test
  void withoutAnActivatorALinkThatCameBackServesTheSameCall() throws Exception {
    activatorIsOutOfReach();
    ConnectException cut = new ConnectException("cut");
    assertThat(proxy(live("alive", cut)).change())
        .as("a command that has not run")
        .isEqualTo("alive");
    assertThat(proxy(live("alive", new UnmarshalException("cut"))).read())
        .as("a question that may have run")
        .isEqualTo("alive");
  }

  @Test
  void withoutAnActivatorTheProxyThatFailedIsTriedByTheNextCall() throws Exception {
    activatorIsOutOfReach();
    for (RemoteException end :
        List.of(new DeadlineExceededException("late"), new UnmarshalException("cut"))) {
      Service service = proxy(live("alive", end));
      assertThatExceptionOfType(end.getClass()).isThrownBy(service::change).isSameAs(end);
      id.asked.clear();
      assertThat(service.change()).as("the call after %s", end).isEqualTo("alive");
      assertThat(id.asked).as("activations before it").containsExactly(false);
      assertThat(service.change()).isEqualTo("alive");
      assertThat(id.asked).as("what answered is trusted again").hasSize(1);
    }
  }

  @Test
  void withoutAnActivatorWhatTheObjectItselfThrowsIsAnAnswer() {
    activatorIsOutOfReach();
    IllegalStateException own = new IllegalStateException("its own");
    Service service = proxy(live("alive", new DeadlineExceededException("late"), own, own));
    assertThatExceptionOfType(DeadlineExceededException.class).isThrownBy(service::change);
    assertThatExceptionOfType(IllegalStateException.class)
        .isThrownBy(service::change)
        .isSameAs(own);
    assertThatExceptionOfType(IllegalStateException.class)
        .isThrownBy(service::change)
        .isSameAs(own);
    assertThat(id.asked).as("what answered is trusted again").hasSize(1);
  }

  @Test
  void withoutAnActivatorACommandIsNeverSentAgainOnceItMayHaveRun() throws Exception {
    activatorIsOutOfReach();
    UnmarshalException broke = new UnmarshalException("cut on the way back");
    Live alive = new Live("alive", null, new ConnectException("cut"), broke);
    Service service = proxy(proxyOf(alive));
    assertThatExceptionOfType(UnmarshalException.class).isThrownBy(service::change).isSameAs(broke);
    assertThat(alive.calls()).as("one that did not run, one that may have").isEqualTo(2);
  }

  @Test
  void withoutAnActivatorADeadObjectIsReportedWithBothReasons() {
    activatorIsOutOfReach();
    ConnectException refused = new ConnectException("refused");
    Live dead = new Live("dead", null, refused, refused, refused);
    assertThatExceptionOfType(ConnectException.class)
        .isThrownBy(() -> proxy(proxyOf(dead)).read())
        .withMessageContaining("the activation system cannot be reached")
        .satisfies(told -> assertThat(told.getSuppressed()).containsExactly(refused));
    assertThat(dead.calls()).isEqualTo(2);

    NoSuchObjectException no = new NoSuchObjectException("no such object");
    Live closed = new Live("closed", null, no, no);
    assertThatExceptionOfType(ConnectException.class)
        .isThrownBy(() -> proxy(proxyOf(closed)).read())
        .satisfies(told -> assertThat(told.getSuppressed()).containsExactly(no));
    assertThat(closed.calls()).as("who says no is not asked again").isEqualTo(1);
  }

  @Test
  void silentActivatorKeepsNobodyFromAnObjectThatLives() throws Exception {
    CountDownLatch never = new CountDownLatch(1);
    id.activating =
        force -> {
          await("the end of the test").forever().until(() -> never.getCount() == 0);
          throw new DeadlineExceededException("no answer");
        };
    try {
      Service service = proxy(live("alive", new DeadlineExceededException("late")));
      assertThatExceptionOfType(DeadlineExceededException.class).isThrownBy(service::change);
      assertThat(service.change()).isEqualTo("alive");
      assertThat(never.getCount()).as("the activator has not answered").isEqualTo(1);
    } finally {
      never.countDown();
    }
  }

  @Test
  void slowActivatorIsWaitedForWhereTheObjectIsDead() throws Exception {
    Live dead =
        new Live("dead", null, new DeadlineExceededException("late"), new ConnectException("x"));
    id.activating =
        force -> {
          await("the last proxy is tried").until(() -> dead.calls() == 2);
          return ResurrectingExporter.proxy(id, live("new"));
        };
    Service service = proxy(proxyOf(dead));
    assertThatExceptionOfType(DeadlineExceededException.class).isThrownBy(service::change);
    assertThat(service.change()).isEqualTo("new");
    assertThat(id.asked).containsExactly(false);
  }

  @Test
  void objectThatComesBackAsAnotherIsRefused() {
    Service service = proxy(gone());
    id.activating = force -> ResurrectingExporter.proxy(new Id("another"), live("new"));
    assertThatExceptionOfType(ActivateFailedException.class)
        .isThrownBy(service::read)
        .withMessage("the object came back under another activation ID");
    id.activating = force -> live("bare");
    assertThatExceptionOfType(ActivateFailedException.class)
        .isThrownBy(service::read)
        .withMessageContaining("without a resurrecting proxy");
  }

  @Test
  void proxiesOfOneObjectAreEqualWhateverIsBehindThem() throws Exception {
    Service one = proxy(live("one"));
    Service other = proxy(live("other"));
    assertThat(one).isEqualTo(other).hasSameHashCodeAs(other);
    assertThat(one).isNotEqualTo(ResurrectingExporter.proxy(new Id("another"), live("one")));
    assertThat(one.equals(null)).isFalse();
    assertThat(one.toString()).contains("Service").contains("ResurrectingHandler");
    assertThat(((TrustEquivalence) one).checkTrustEquivalence(other)).isTrue();
    assertThat(((TrustEquivalence) one).checkTrustEquivalence("text")).isFalse();

    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
      out.writeObject(one);
    }
    Service read =
        (Service) new ObjectInputStream(new ByteArrayInputStream(bytes.toByteArray())).readObject();
    assertThat(read).isEqualTo(one).hasSameHashCodeAs(one);
    assertThat(read.read()).as("the copy still knows the live one").isEqualTo("one");
  }

  @Test
  void constrainedProxyStillResurrectsAndConstrainsWhatComesBack() throws Exception {
    InvocationConstraint integrity = Integrity.YES;
    MethodConstraints constraints =
        new BasicMethodConstraints(new InvocationConstraints(integrity, null));
    ConnectException dead = new ConnectException("dead");
    Service constrained =
        (Service) ((RemoteMethodControl) proxy(live("old", dead))).setConstraints(constraints);
    assertThat(((RemoteMethodControl) constrained).getConstraints()).isEqualTo(constraints);
    assertThat(constrained).isNotEqualTo(proxy(live("old")));
    id.bringsBack(live("new"));
    assertThat(constrained.change()).isEqualTo("new constrained");
    assertThat(id.asked).hasSize(1);
  }

  @Test
  void manyCallersOfADyingObjectAllGetThrough() throws Exception {
    ConnectException dead = new ConnectException("dead");
    Service service = proxy(live("old", Collections.nCopies(200, dead).toArray(Throwable[]::new)));
    id.activating =
        force ->
            ResurrectingExporter.proxy(
                id,
                force
                    ? live("new")
                    : live("old", Collections.nCopies(200, dead).toArray(Throwable[]::new)));
    Callable<String> call = service::read;
    for (Future<String> each : threads.invokeAll(Collections.nCopies(64, call))) {
      assertThat(each.get()).isEqualTo("new");
    }
  }
}
