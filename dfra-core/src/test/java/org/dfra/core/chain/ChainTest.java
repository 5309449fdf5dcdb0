package org.dfra.core.chain;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.time.Instant;
import java.time.InstantSource;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import org.dfra.core.config.Parameters;
import org.dfra.core.module.ChainPlace;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ModuleImpl;
import org.dfra.core.module.SensorImpl;
import org.dfra.event.Reading;
import org.dfra.flow.Chainable;
import org.dfra.module.Module;
import org.dfra.module.Readiness;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** A chain in one virtual machine: two thermometers, and a schema that tells Kelvin of one. */
@Timeout(30)
class ChainTest {

  private record Celsius(double degrees, Instant measured) implements Reading {}

  private record Kelvin(double degrees, Instant measured) implements Reading {}

  private final Map<String, ModuleImpl> modules = new ConcurrentHashMap<>();
  private final Thermometer indoors = new Thermometer("indoors");
  private final Thermometer outdoors = new Thermometer("outdoors");
  private final ToKelvin schema = new ToKelvin();
  private final List<Double> told = new CopyOnWriteArrayList<>();

  @AfterEach
  void end() {
    modules.values().forEach(ModuleImpl::close);
  }

  @Test
  void flowsAndIsRewiredWhileItRuns() throws Exception {
    modules.values().forEach(ModuleImpl::start);
    new ChainInputs(
            "atrv1/test", this::find, (input, reading) -> told.add(((Kelvin) reading).degrees()))
        .wire(List.of("atrv1/to_kelvin"));
    schema.setInputs(List.of("atrv1/indoors"));
    assertThat(indoors.readiness()).as("it has a client now").isEqualTo(Readiness.ACTIVE);
    indoors.measure(20);
    outdoors.measure(-5);
    await().until(() -> told.contains(293.15));

    schema.setInputs(List.of("atrv1/outdoors"));
    assertThat(schema.inputs()).containsExactly("atrv1/outdoors");
    assertThat(indoors.readiness()).isEqualTo(Readiness.READY);
    indoors.measure(21);
    outdoors.measure(-10);
    await().until(() -> told.contains(263.15));
    assertThat(told).containsExactly(293.15, 263.15);
  }

  @Test
  void keepsItsWiringWhenANewOneIsRefused() {
    modules.values().forEach(ModuleImpl::start);
    schema.setInputs(List.of("atrv1/indoors"));
    assertThatThrownBy(() -> schema.setInputs(List.of("atrv1/sauna")))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("atrv1/to_kelvin cannot be wired to atrv1/sauna: there is no such module");
    assertThatThrownBy(() -> schema.setInputs(List.of("atrv1/indoors", "atrv1/outdoors")))
        .hasMessage("atrv1/to_kelvin takes 1 inputs (Celsius) or none, but was given 2");
    assertThat(schema.inputs()).containsExactly("atrv1/indoors");
    assertThat(indoors.readiness()).isEqualTo(Readiness.ACTIVE);
  }

  private Optional<Module> find(String path) {
    return Optional.ofNullable(modules.get(path));
  }

  private ModuleContext context(String name) {
    return new ModuleContext(
        "atrv1", name, Parameters.of("atrv1/" + name, Map.of()), InstantSource.system());
  }

  private final class Thermometer extends SensorImpl {

    Thermometer(String name) {
      super(context(name), "a thermometer", "DFRA", "1", List.of("Celsius"), List.of());
      modules.put("atrv1/" + name, this);
    }

    void measure(double degrees) {
      tell(new Celsius(degrees, Instant.EPOCH));
    }

    @Override
    public double updateRate() {
      return 0;
    }

    @Override
    protected void onStart() {
      become(Readiness.READY);
    }

    @Override
    protected void onClose() {}
  }

  private final class ToKelvin extends ModuleImpl implements Chainable {

    private final ChainInputs inputs = new ChainInputs(path(), ChainTest.this::find, this::take);
    private final ChainPlace place =
        new ChainPlace(path(), List.of("Celsius"), List.of("Kelvin"), inputs::wire);

    ToKelvin() {
      super(context("to_kelvin"), "tells Kelvin", "DFRA", "1");
      modules.put("atrv1/to_kelvin", this);
    }

    private void take(int input, Reading reading) {
      tell(new Kelvin(((Celsius) reading).degrees() + 273.15, reading.measured()));
    }

    @Override
    protected void onStart() {
      become(Readiness.READY);
    }

    @Override
    protected void onClose() {
      inputs.close();
    }

    @Override
    public List<String> inputTypes() {
      return place.inputTypes();
    }

    @Override
    public List<String> outputTypes() {
      return place.outputTypes();
    }

    @Override
    public List<String> inputs() {
      return place.inputs();
    }

    @Override
    public List<String> outputs() {
      return place.outputs();
    }

    @Override
    public void setInputs(List<String> wanted) {
      place.setInputs(wanted);
    }

    @Override
    public void setOutputs(List<String> wanted) {
      place.setOutputs(wanted);
    }
  }
}
