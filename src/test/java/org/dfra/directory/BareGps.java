package org.dfra.directory;

import java.time.Duration;
import java.util.List;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleListener;
import org.dfra.event.Subscription;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.geometry.Transform;
import org.dfra.lease.ModuleLease;
import org.dfra.module.Diagnosis;
import org.dfra.module.LogLevel;
import org.dfra.module.ModuleHistory;
import org.dfra.module.Parameter;
import org.dfra.module.Precondition;

/** A receiver that offers nothing of what every module offers besides, for lists to hold. */
interface BareGps extends GPSSensor {

  private static UnsupportedOperationException none() {
    return new UnsupportedOperationException("no test of a list asks for this");
  }

  @Override
  default Subscription subscribe(ModuleListener listener, DeliveryPolicy policy) {
    throw none();
  }

  @Override
  default ModuleLease acquireLease(Duration duration) {
    throw none();
  }

  @Override
  default ModuleHistory history() {
    throw none();
  }

  @Override
  default LogLevel logLevel() {
    throw none();
  }

  @Override
  default void setLogLevel(LogLevel level) {
    throw none();
  }

  @Override
  default List<Parameter> parameters() {
    throw none();
  }

  @Override
  default void setParameter(String name, String text) {
    throw none();
  }

  @Override
  default String frame() {
    throw none();
  }

  @Override
  default String parentFrame() {
    throw none();
  }

  @Override
  default Transform localTransform() {
    throw none();
  }

  @Override
  default List<Precondition> preconditions() {
    throw none();
  }

  @Override
  default List<String> tests() {
    throw none();
  }

  @Override
  default Diagnosis test(String name) {
    throw none();
  }

  @Override
  default List<String> recoveries() {
    throw none();
  }

  @Override
  default Diagnosis recover(String name) {
    throw none();
  }

  @Override
  default List<String> inputTypes() {
    throw none();
  }

  @Override
  default List<String> outputTypes() {
    throw none();
  }

  @Override
  default List<String> inputs() {
    throw none();
  }

  @Override
  default List<String> outputs() {
    throw none();
  }

  @Override
  default void setInputs(List<String> modules) {
    throw none();
  }

  @Override
  default void setOutputs(List<String> modules) {
    throw none();
  }
}
