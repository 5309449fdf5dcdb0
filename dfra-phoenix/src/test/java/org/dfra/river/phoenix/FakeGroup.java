package org.dfra.river.phoenix;

import java.io.IOException;
import java.rmi.MarshalledObject;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationDesc;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationID;
import java.rmi.activation.ActivationInstantiator;
import java.util.concurrent.atomic.AtomicInteger;
import net.jini.jeri.BasicJeriExporter;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.Endpoints;
import org.dfra.river.phoenix.stop.GroupStopResult;
import org.dfra.river.phoenix.stop.StoppableGroup;

/** Plays the part of a group's virtual machine; each object it makes is a proxy of itself. */
final class FakeGroup implements ActivationInstantiator, StoppableGroup, AutoCloseable {

  /** What happens when an object is wanted. */
  interface Making {
    void run() throws ActivationException, RemoteException;
  }

  /** What happens when its effectors are to be stopped. */
  interface Stopping {
    GroupStopResult run(String by) throws RemoteException;
  }

  final AtomicInteger made = new AtomicInteger();
  final AtomicInteger ordered = new AtomicInteger();
  final ActivationInstantiator proxy;
  volatile Making making = () -> {};
  volatile Stopping stopping = by -> GroupStopResult.NONE;
  private final BasicJeriExporter exporter =
      new BasicJeriExporter(
          Endpoints.tcp("127.0.0.1", 0), new DeadlineILFactory(20_000L), false, true);

  FakeGroup() throws IOException {
    proxy = (ActivationInstantiator) exporter.export(this);
  }

  @Override
  public MarshalledObject<? extends Remote> newInstance(ActivationID id, ActivationDesc desc)
      throws ActivationException, RemoteException {
    made.incrementAndGet();
    making.run();
    try {
      return new MarshalledObject<>(proxy);
    } catch (IOException e) {
      throw new RemoteException("unexpected", e);
    }
  }

  @Override
  public GroupStopResult emergencyStop(String by) throws RemoteException {
    ordered.incrementAndGet();
    return stopping.run(by);
  }

  @Override
  public void close() {
    exporter.unexport(true);
  }
}
