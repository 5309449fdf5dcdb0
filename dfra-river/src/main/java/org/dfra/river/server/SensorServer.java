package org.dfra.river.server;

import java.rmi.MarshalledObject;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationID;
import java.util.List;
import java.util.UUID;
import org.dfra.flow.sensor.Sensor;
import org.dfra.geometry.Transform;
import org.dfra.module.Diagnosis;
import org.dfra.module.Precondition;
import org.dfra.river.remote.RemoteSensor;
import org.jspecify.annotations.Nullable;

/**
 * Activatable server of a sensor.
 *
 * @param <S> the sensor's interface
 */
public abstract class SensorServer<S extends Sensor> extends ModuleServer<S>
    implements RemoteSensor {

  private final ExaminationRuns examinations;

  /** See {@link ModuleServer#ModuleServer}. */
  protected SensorServer(
      Class<S> kind, @Nullable ActivationID id, MarshalledObject<ModuleActivation> data)
      throws Exception {
    super(kind, id, data);
    this.examinations = new ExaminationRuns(path(), module());
  }

  @Override
  public final double updateRate() throws RemoteException {
    return module().updateRate();
  }

  @Override
  public final String frame() throws RemoteException {
    return module().frame();
  }

  @Override
  public final String parentFrame() throws RemoteException {
    return module().parentFrame();
  }

  @Override
  public final Transform localTransform() throws RemoteException {
    return module().localTransform();
  }

  @Override
  public final List<Precondition> preconditions() throws RemoteException {
    return module().preconditions();
  }

  @Override
  public final List<String> tests() throws RemoteException {
    return module().tests();
  }

  /** {@inheritDoc} The call's deadline counts; a proxy has none. */
  @Override
  public final Diagnosis test(String name) throws RemoteException {
    return module().test(name);
  }

  @Override
  public final List<String> recoveries() throws RemoteException {
    return module().recoveries();
  }

  /** {@inheritDoc} The call's deadline counts; a proxy has none. */
  @Override
  public final Diagnosis recover(String name) throws RemoteException {
    return module().recover(name);
  }

  @Override
  public final UUID beginExamination(Sort sort, String name) throws RemoteException {
    return examinations.begin(sort, name);
  }

  @Override
  public final @Nullable Diagnosis examination(UUID run) {
    return examinations.await(run, LONGEST_WAIT);
  }

  @Override
  public final List<String> inputTypes() throws RemoteException {
    return module().inputTypes();
  }

  @Override
  public final List<String> outputTypes() throws RemoteException {
    return module().outputTypes();
  }

  @Override
  public final List<String> inputs() throws RemoteException {
    return module().inputs();
  }

  @Override
  public final List<String> outputs() throws RemoteException {
    return module().outputs();
  }

  @Override
  public final void setInputs(List<String> modules) throws RemoteException {
    module().setInputs(modules);
  }

  @Override
  public final void setOutputs(List<String> modules) throws RemoteException {
    module().setOutputs(modules);
  }
}
