package org.dfra.river.call;

import java.io.Serializable;
import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.rmi.ConnectException;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationID;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.AtomicInteger;
import net.jini.core.constraint.MethodConstraints;
import net.jini.core.constraint.RemoteMethodControl;
import net.jini.security.proxytrust.TrustEquivalence;
import org.dfra.module.Idempotent;
import org.junit.jupiter.api.AfterEach;

/** A resurrecting proxy, whose object dies and comes back as the test says. */
abstract class ResurrectionFixture {

  /** What is served here. */
  public interface Service extends Remote {
    @Idempotent
    String read() throws RemoteException;

    String change() throws RemoteException;
  }

  /** A live proxy that fails with these exceptions, and then answers with its name. */
  static final class Live implements InvocationHandler, Serializable {
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

  /** A live proxy of that name, whose first calls fail with these exceptions. */
  static Remote live(String name, Throwable... failures) {
    return proxyOf(new Live(name, null, failures));
  }

  static Remote proxyOf(Live live) {
    return (Remote)
        Proxy.newProxyInstance(
            Service.class.getClassLoader(),
            new Class<?>[] {Service.class, RemoteMethodControl.class},
            live);
  }

  /** Decides what the activator does. */
  interface Activating {
    Remote activate(boolean force) throws ActivationException, RemoteException;
  }

  /** An ID whose activation is the test's. */
  static final class Id extends ActivationID implements TrustEquivalence {
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

  final Id id = new Id("object");
  final ExecutorService threads = Executors.newCachedThreadPool();

  @AfterEach
  void end() {
    threads.shutdownNow();
  }

  /** The resurrecting proxy of the object, which has that live one. */
  Service proxy(Remote live) {
    return (Service) ResurrectingExporter.proxy(id, live);
  }

  /** A live proxy that has just been forgotten, so that the first call must activate. */
  static Remote gone() {
    return live(
        "gone", Collections.nCopies(64, new ConnectException("gone")).toArray(Throwable[]::new));
  }
}
