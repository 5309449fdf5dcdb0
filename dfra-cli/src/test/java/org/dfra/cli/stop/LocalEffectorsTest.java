package org.dfra.cli.stop;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.ConnectException;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.dfra.cli.stop.LocalEffectors.LocalEffector;
import org.dfra.core.config.RobotDescription;
import org.dfra.core.config.RobotXml;
import org.dfra.river.bootstrap.PhoenixInventory.RegisteredService;
import org.dfra.river.server.effector.DriveServer;
import org.dfra.river.server.sensor.GPSServer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Which effectors of a host are stopped where no lookup service has them. */
class LocalEffectorsTest {

  @TempDir Path folder;

  private static RegisteredService service(String group, String name, Class<?> server) {
    return new RegisteredService(group, name, server.getName(), null);
  }

  private RobotDescription robot(String module) throws IOException {
    return RobotXml.read(
        Files.writeString(
            folder.resolve("r.xml"),
            """
            <robot xmlns="urn:dfra:robot:1" name="r" host="127.0.0.1">
              <group name="wheels">
                <module name="%s" server="%s" proxy="a.Proxy" implementation="a.Driver"/>
                <module name="gps" server="%s" proxy="a.Proxy" implementation="a.Driver"/>
              </group>
            </robot>
            """
                .formatted(module, DriveServer.class.getName(), GPSServer.class.getName())));
  }

  /**
   * A phoenix that has these registered; null where it does not answer. No lambda: JUnit reads the
   * methods of this class also where there is no {@code java.rmi.activation}.
   */
  private record FakePhoenix(List<RegisteredService> registered, AtomicInteger asked)
      implements LocalEffectors.RegisteredServices {
    @Override
    public List<RegisteredService> services() throws IOException {
      asked.incrementAndGet();
      if (registered == null) {
        throw new ConnectException("refused; nested exception is: \n\tjava.net.X");
      }
      return registered;
    }
  }

  private final AtomicInteger asked = new AtomicInteger();

  private List<LocalEffector> all(List<RegisteredService> registered, RobotDescription... known)
      throws Exception {
    return new LocalEffectors(new FakePhoenix(registered, asked), List.of(known), "r"::equals)
        .all();
  }

  @Test
  void oneThatTheXmlNamesNoLongerIsFoundAsPhoenixHasItRegistered() throws Exception {
    List<LocalEffector> all =
        all(
            List.of(
                service("r.wheels", "drive", DriveServer.class),
                service("r.wheels", "gps", GPSServer.class),
                service("other.wheels", "drive", DriveServer.class)),
            robot("motor"));
    assertThat(all).extracting(LocalEffector::path).containsExactly("r/drive", "r/motor");
    assertThatThrownBy(() -> all.get(1).access().reach())
        .hasMessageContaining("does not have it registered");
  }

  @Test
  void oneThatBothKnowIsFoundOnceAndThoseOfOneNameInTwoGroupsAreBoth() throws Exception {
    assertThat(
            all(
                List.of(
                    service("r.wheels", "drive", DriveServer.class),
                    service("r.former", "drive", DriveServer.class)),
                robot("drive")))
        .extracting(LocalEffector::path)
        .containsExactly("r/drive", "r/drive");
  }

  @Test
  void wherePhoenixDoesNotAnswerThatIsSaidOfThoseInTheXml() throws Exception {
    List<LocalEffector> all = all(null, robot("drive"));
    assertThat(asked).hasValue(2);
    assertThat(all).extracting(LocalEffector::path).containsExactly("r/drive");
    assertThatThrownBy(() -> all.get(0).access().reach())
        .hasMessage("no lookup service has it, and phoenix of this host cannot be asked: refused");
    assertThatThrownBy(() -> all(null)).isInstanceOf(ConnectException.class);
  }
}
