package org.dfra.drivers.link;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.locks.Condition;
import org.dfra.drivers.fixture.ScriptedLink;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class LinkAddressTest {

  @TempDir private Path folder;

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "ttyS0 | it begins with no scheme; write serial:/dev/ttyS0?baud=9600, tcp://host:port, replay:",
        ":9000 | it begins with no scheme; write serial:",
        "udp://host:1 | the scheme \"udp\" is unknown; write serial:/dev/ttyS0?baud=9600, tcp://",
        "serial: | it names no port; write serial:/dev/ttyS0?baud=9600",
        "serial:/dev/ttyS0?bd=9600 | the option bd is unknown; serial takes baud, bits, parity, stop",
        "serial:/dev/ttyS0?baud=fast | baud is \"fast\", which is not a whole number from 50 to 4000000",
        "serial:/dev/ttyS0?baud=1 | baud is \"1\", which is not a whole number from 50 to 4000000",
        "serial:/dev/ttyS0?bits=9 | bits is \"9\", which is not a whole number from 5 to 8",
        "serial:/dev/ttyS0?parity=maybe | parity is \"maybe\"; allowed are even, mark, none, odd, space",
        "serial:/dev/ttyS0?stop=3 | stop is \"3\"; allowed are 1, 1.5, 2",
        "serial:/dev/ttyS0?baud | the option \"baud\" is not of the form name=value",
        "serial:/dev/ttyS0?baud= | the option \"baud=\" is not of the form name=value",
        "serial:/dev/ttyS0? | the option \"\" is not of the form name=value",
        "serial:/dev/ttyS0?baud=9600&baud=9600 | the option baud is given twice; keep one of them",
        "tcp:host:1 | two slashes are missing; write tcp://host:port, the port from 1 to 65535",
        "tcp://host | it names no port; write tcp://host:port, the port from 1 to 65535",
        "tcp://[::1] | it names no port; write tcp://host:port, the port from 1 to 65535",
        "tcp://:4001 | it names no host; write tcp://host:port, the port from 1 to 65535",
        "tcp://host:abc | the port is \"abc\", which is not a number; write tcp://host:port",
        "tcp://host:1/x | the port is \"1/x\", which is not a number; write tcp://host:port",
        "tcp://host:0 | the port is 0; write tcp://host:port, the port from 1 to 65535",
        "tcp://host:65536 | the port is 65536; write tcp://host:port, the port from 1 to 65535",
        "tcp://host:1?baud=9600 | the option baud is unknown; tcp takes no options",
        "replay: | it names no file; write replay:file?pace=1.0",
        "replay:file?speed=2 | the option speed is unknown; replay takes baud, loop, pace",
        "replay:file?pace=-1 | pace is \"-1\", which is not a number of 0.0 or more",
        "replay:file?pace=NaN | pace is \"NaN\", which is not a number of 0.0 or more",
        "replay:file?pace=Infinity | pace is \"Infinity\", which is not a number of 0.0 or more",
        "replay:file?loop=yes | loop is \"yes\"; allowed are false, true",
        "sim: | it names no simulated device; write sim:name",
        "sim:gps?baud=9600 | the option baud is unknown; sim takes no options",
      })
  void refusesBadUrlSayingWhatIsAllowed(String url, String sentence) {
    assertThatThrownBy(() -> LinkAddress.parse(url))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageStartingWith("link \"" + url + "\": " + sentence);
  }

  @Test
  void readsEveryPartAndPrintsItselfAsWritten() {
    String serial = "serial:/dev/ttyUSB1?baud=38400&bits=7&parity=even&stop=2";
    assertThat(LinkAddress.parse(serial))
        .isEqualTo(new SerialAddress(serial, "/dev/ttyUSB1", 38400, 7, "even", "2"))
        .hasToString(serial);
    assertThat(LinkAddress.parse("serial:COM3"))
        .isEqualTo(new SerialAddress("serial:COM3", "COM3", 9600, 8, "none", "1"));
    assertThat(LinkAddress.parse("tcp://robot-1.example:4001"))
        .isEqualTo(new TcpAddress("tcp://robot-1.example:4001", "robot-1.example", 4001));
    assertThat(LinkAddress.parse("tcp://[::1]:4001"))
        .isEqualTo(new TcpAddress("tcp://[::1]:4001", "::1", 4001));
    assertThat(LinkAddress.parse("replay:a b:c.log?pace=0&baud=115200&loop=true"))
        .isEqualTo(
            new ReplayAddress(
                "replay:a b:c.log?pace=0&baud=115200&loop=true",
                Path.of("a b:c.log"),
                0,
                115200,
                true));
  }

  @Test
  void opensASimulatedDeviceOfTheTimeItIsGiven() throws IOException {
    SimLinkRegistry links = new SimLinkRegistry("none has been started");
    Ticker time = timeWith(links);
    LinkAddress address = LinkAddress.parse("sim:atrv1/gps");
    assertThat(address).hasToString("sim:atrv1/gps");
    assertThatThrownBy(() -> address.open(time))
        .isInstanceOf(IOException.class)
        .hasMessage("sim:atrv1/gps: there is no simulated device atrv1/gps; none has been started");
    SimLinkRegistry.LinkFactory port = asked -> new ScriptedLink(asked.url());
    links.add("atrv1/gps", port);
    links.add("atrv1/laser", port);
    assertThat(address.open(time)).hasToString("sim:atrv1/gps");
    assertThatThrownBy(() -> links.add("atrv1/gps", port))
        .hasMessage("there is a simulated device sim:atrv1/gps already; name this one otherwise");
    assertThatThrownBy(() -> LinkAddress.parse("sim:gps").open(time))
        .isInstanceOf(IOException.class)
        .hasMessage(
            "sim:gps: there is no simulated device gps; there are atrv1/gps, atrv1/laser: name one"
                + " of them, or have the simulation start gps");
    links.remove("atrv1/laser", asked -> new ScriptedLink("another"));
    links.remove("atrv1/gps", port);
    assertThatThrownBy(() -> address.open(time)).hasMessageContaining("; there are atrv1/laser:");
  }

  @Test
  void refusesNamesThatNoUrlCanHave() {
    SimLinkRegistry links = new SimLinkRegistry("none has been started");
    for (String name : new String[] {"", " ", "gps?baud=9600"}) {
      assertThatThrownBy(() -> links.add(name, asked -> new ScriptedLink(asked.url())))
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessageStartingWith("\"" + name + "\" cannot be the name of a simulated device");
    }
  }

  @Test
  void saysThatRealTimeHasNoSimulatedDevices() {
    assertThatThrownBy(() -> LinkAddress.open("sim:gps"))
        .isInstanceOf(IOException.class)
        .hasMessage(
            "sim:gps: there is no simulated device gps; this module lives by real time, and sim:"
                + " links are of a simulation in lock-step only; write serial:, tcp: or replay:,"
                + " or give the module the simulation's clock");
  }

  private static Ticker timeWith(SimLinkRegistry links) {
    return new Ticker() {
      @Override
      public long nanos() {
        return 0;
      }

      @Override
      public void await(Condition condition, long nanos) {
        throw new AssertionError("nobody waits here");
      }

      @Override
      public SimLinkRegistry simLinks() {
        return links;
      }
    };
  }

  @Test
  void saysWhichRecordingIsMissingOrEmpty() throws IOException {
    Path missing = folder.resolve("missing.log");
    assertThatThrownBy(() -> LinkAddress.open("replay:" + missing))
        .isInstanceOf(IOException.class)
        .hasMessage("replay:" + missing + ": there is no file " + missing + "; name a recording");
    Path empty = Files.createFile(folder.resolve("empty.log"));
    assertThatThrownBy(() -> LinkAddress.open("replay:" + empty + "?loop=true"))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("the file is empty");
  }

  @Test
  void saysThatThereIsNoSuchSerialPort() {
    assertThatThrownBy(() -> LinkAddress.open("serial:/dev/ttyNotThere7?baud=9600"))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("there is no port /dev/ttyNotThere7");
  }
}
