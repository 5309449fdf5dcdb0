package org.dfra.directory;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.UUID;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.lifecycle.Readiness;
import org.dfra.persona.Attributes;
import org.dfra.persona.ChainAttributes;
import org.dfra.persona.ModuleAttributes;
import org.dfra.persona.PersonaAttributes;
import org.dfra.persona.SensorAttributes;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;

/** A directory with modules before it, by whatever means. */
abstract class DirectoryFixture {

  static final Duration PATIENCE = Duration.ofSeconds(30);

  /** A directory together with the means to put modules before it. */
  interface Fixture extends AutoCloseable {
    ModuleDirectory directory();

    /** Makes a module known, or known again. */
    void announce(ListedGps module, List<Attributes> attributes, Locality locality)
        throws Exception;

    /** Makes a robot as such known. */
    void announce(PersonaAttributes robot) throws Exception;

    /** The module is gone for certain. */
    void withdraw(UUID id) throws Exception;

    /** Every lookup service that listed the known modules is out of reach. */
    void loseSight() throws Exception;
  }

  Fixture fixture;
  ModuleDirectory directory;

  abstract Fixture fixture() throws Exception;

  @BeforeEach
  void begin() throws Exception {
    fixture = fixture();
    directory = fixture.directory();
  }

  @AfterEach
  void end() throws Exception {
    directory.close();
    fixture.close();
  }

  static ModuleAttributes module(String robot, String name, String host, Readiness state) {
    return new ModuleAttributes(
        robot, name, "org.example.Driver", host, "DFRA", "1", state, Instant.EPOCH, null, 0);
  }

  static List<Attributes> attributes(String robot, String name, double maxRate) {
    return List.of(
        module(robot, name, "127.0.0.1", Readiness.READY),
        new ChainAttributes(List.of(), List.of("GpsFix")),
        new SensorAttributes("GpsFix", List.of("continuous"), 0.1, maxRate, null, List.of()));
  }

  static List<Attributes> and(List<Attributes> some, Attributes... more) {
    List<Attributes> all = new ArrayList<>(some);
    all.addAll(Arrays.asList(more));
    return all;
  }

  ListedGps list(String robot, String name, double maxRate) throws Exception {
    return list(name, attributes(robot, name, maxRate), Locality.SAME_HOST);
  }

  ListedGps list(String name, List<Attributes> attributes, Locality locality) throws Exception {
    ListedGps module = new ListedGps(UUID.randomUUID(), name);
    fixture.announce(module, attributes, locality);
    ModuleAttributes who = (ModuleAttributes) attributes.get(0);
    assertThat(
            directory.findFirst(
                ModuleQuery.of(GPSSensor.class).robot(who.robot()).name(who.name()), PATIENCE))
        .as(name)
        .isPresent();
    return module;
  }
}
