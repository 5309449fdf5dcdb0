package org.dfra.drivers.uav.mavlink;

import static org.dfra.drivers.fixture.Modules.await;
import static org.dfra.drivers.fixture.Modules.texts;

import java.time.Instant;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import org.dfra.core.config.Parameters;
import org.dfra.core.module.ModuleContext;
import org.dfra.drivers.fixture.ScriptedLink;
import org.dfra.drivers.fixture.StepTicker;
import org.dfra.drivers.link.LinkKeeper;
import org.dfra.drivers.uav.mavlink.MavlinkParser.MavlinkFramer;
import org.junit.jupiter.api.Timeout;

/** A link that says what the test has it say, on stepped time, and frames of a vehicle. */
@Timeout(120)
abstract class MavlinkFixture {

  static final byte[] HEARTBEAT =
      hex("FD09000011010100000000000403020C9D0403DE49"); // PX4, armed, in the air
  static final byte[] POSITION =
      hex("FD1C000007010121000040E2010050ECA810A007DACE24F40000204E00002C0170FECEFF0C7B14BD");
  static final byte[] RECEIVER =
      hex(
          "FD2C000008010118000000909B68E548060050ECA810A007DACE409C00005A007800F401DF77030B"
              + "A4380000DC050000C40900002C01285C");
  static final byte[] FLIES = hex("FD0200000A0101F5000000024E27");
  static final byte[] SUPPLY =
      hex(
          "FD1F00000B0101010000000000000000000000000000FA00B83DD204000000000000000000000000"
              + "57024D");
  static final byte[] BATTERY =
      hex(
          "FD2400000D0101930000FFFFFFFFFFFFFFFFFF7FA00FA00F3C0F3C0FFFFFFFFFFFFFFFFFFFFFFFFF"
              + "6AFF0000013F4737");

  /** {@code COMMAND_ACK} of {@code DO_SET_MODE}, 176. */
  static final byte[] MODE_ACCEPTED = summed(hex("FD030000010101" + "4D0000" + "B000000000"), 143);

  final StepTicker ticker = new StepTicker(false);
  final List<ScriptedLink> links = new CopyOnWriteArrayList<>();
  final LinkKeeper.Source source =
      () -> {
        ScriptedLink link = new ScriptedLink("tcp://uav:1");
        links.add(link);
        return link;
      };

  /** Says it on the link that is open now, or will be. */
  void say(byte[]... frames) {
    await().until(() -> !links.isEmpty());
    for (byte[] frame : frames) {
      links.get(links.size() - 1).say(frame);
    }
  }

  /** The frame with its checksum; {@code extra} is that of its message. */
  static byte[] summed(byte[] frame, int extra) {
    int sum = MavlinkFramer.checksum(frame, 1, frame.length - 2, extra);
    frame[frame.length - 2] = (byte) sum;
    frame[frame.length - 1] = (byte) (sum >> 8);
    return frame;
  }

  static ModuleContext context(String name, String... parameters) {
    Map<String, String> all = texts("link", "tcp://uav:1");
    all.putAll(texts(parameters));
    return new ModuleContext("uav", name, Parameters.of("uav/" + name, all), Instant::now);
  }

  private static byte[] hex(String text) {
    return HexFormat.of().parseHex(text);
  }
}
