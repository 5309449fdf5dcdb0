package org.dfra.core.policy;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.util.List;
import org.dfra.core.policy.method.InterfaceCatalogue;
import org.dfra.core.policy.method.MethodKind;
import org.dfra.core.policy.method.MethodKinds;
import org.dfra.flow.sensor.Sensor;
import org.dfra.module.Administrative;
import org.dfra.module.Idempotent;
import org.junit.jupiter.api.Test;

/** The kinds of the methods of modules of your own. */
class MethodKindsTest {

  /** A module of somebody's own. */
  interface Thermometer extends Sensor {
    @Idempotent
    double temperature() throws RemoteException;

    @Idempotent
    void reset() throws RemoteException;

    @Administrative
    void calibrate() throws RemoteException;

    void heat() throws RemoteException;

    /** Stricter than in the interface that declares it. */
    @Override
    @Administrative
    double updateRate() throws RemoteException;
  }

  abstract static class ThermometerServer implements Remote, Thermometer {}

  private static MethodKind kind(String method) {
    return MethodKinds.of(
            ThermometerServer.class, PolicyFixture.method(ThermometerServer.class, method))
        .kind();
  }

  @Test
  void annotationsSayTheKindsOfYourOwnMethods() {
    assertThat(kind("temperature")).isEqualTo(MethodKind.READ);
    assertThat(kind("reset"))
        .as("no query, since it returns nothing")
        .isEqualTo(MethodKind.COMMAND);
    assertThat(kind("calibrate")).isEqualTo(MethodKind.ADMINISTER);
    assertThat(kind("heat")).as("nothing is said").isEqualTo(MethodKind.COMMAND);
    assertThat(
            MethodKinds.of(Thermometer.class, PolicyFixture.method(Thermometer.class, "heat"))
                .isDeclared())
        .isFalse();
  }

  @Test
  void theTableSaysTheKindsOfDfrasMethodsAndTheStricterOfTwoCounts() {
    assertThat(kind("readiness")).isEqualTo(MethodKind.READ);
    assertThat(kind("subscribe")).isEqualTo(MethodKind.LISTEN);
    assertThat(kind("updateRate")).isEqualTo(MethodKind.ADMINISTER);
  }

  @Test
  void aPolicyMayNameInterfacesOfYourOwn() {
    InterfaceCatalogue catalogue = InterfaceCatalogue.builtIn().with(List.of(Thermometer.class));
    String rule = "<permit interface=\"Thermometer\" method=\"temperature,readiness\"/>";
    assertThat(
            PolicyXml.read(
                    PolicyFixture.xml(1, rule).getBytes(StandardCharsets.UTF_8),
                    "policy.xml",
                    catalogue)
                .rules())
        .hasSize(1);

    String full = rule.replace("\"Thermometer\"", "\"" + Thermometer.class.getName() + "\"");
    InterfaceCatalogue loading =
        InterfaceCatalogue.builtIn().withInterfacesOf(MethodKindsTest.class.getClassLoader());
    Policy policy =
        PolicyXml.read(
            PolicyFixture.xml(1, full).getBytes(StandardCharsets.UTF_8), "policy.xml", loading);
    assertThat(
            new PolicyGuard(policy)
                .decide(
                    PolicyFixture.call(PolicyFixture.ANNA, ThermometerServer.class, "temperature"))
                .isPermitted())
        .isTrue();
  }
}
