package org.dfra.drivers.gps.gpsd;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.List;
import org.dfra.drivers.fixture.Sentences;
import org.dfra.drivers.gps.gpsd.GpsdMessage.Device;
import org.dfra.drivers.gps.gpsd.GpsdMessage.Devices;
import org.dfra.drivers.gps.gpsd.GpsdMessage.Malformed;
import org.dfra.drivers.gps.gpsd.GpsdMessage.Other;
import org.dfra.drivers.gps.gpsd.GpsdMessage.Satellite;
import org.dfra.drivers.gps.gpsd.GpsdMessage.Sky;
import org.dfra.drivers.gps.gpsd.GpsdMessage.Tpv;
import org.dfra.drivers.gps.gpsd.GpsdMessage.Version;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class GpsdDecoderTest {

  @Test
  void readsPositions() {
    assertThat(
            decode(
                "{\"class\":\"TPV\",\"device\":\"/dev/ttyS0\",\"status\":2,\"mode\":3,"
                    + "\"time\":\"2026-01-21T07:33:30.250Z\",\"lat\":-52.5,\"lon\":6,"
                    + "\"altHAE\":55.91,\"altMSL\":12.4,\"track\":90.5,\"speed\":1.25,"
                    + "\"eph\":3.5,\"epv\":7,\"new\":{\"deep\":[1,2]}}"))
        .isEqualTo(
            new Tpv(
                "/dev/ttyS0",
                3,
                2,
                Instant.parse("2026-01-21T07:33:30.250Z"),
                -52.5,
                6,
                55.91,
                1.25,
                90.5,
                3.5,
                7));
    assertThat(decode("{\"class\":\"TPV\",\"mode\":1}"))
        .isEqualTo(
            new Tpv(
                "",
                1,
                0,
                null,
                Double.NaN,
                Double.NaN,
                Double.NaN,
                Double.NaN,
                Double.NaN,
                Double.NaN,
                Double.NaN));
  }

  @Test
  void minusOneIsUnknownWhereANumberCannotBeNegative() {
    assertThat(
            decode(
                "{\"class\":\"SKY\",\"hdop\":-1,\"pdop\":-1.0,\"satellites\":[{\"PRN\":14,"
                    + "\"gnssid\":-1,\"svid\":-1,\"el\":-1,\"az\":-1,\"ss\":-1,"
                    + "\"used\":false}]}"))
        .isEqualTo(
            new Sky(
                List.of(new Satellite(14, -1, -1, -1, Double.NaN, Double.NaN, false)),
                Double.NaN,
                Double.NaN));
    Tpv tpv =
        (Tpv)
            decode(
                "{\"class\":\"TPV\",\"mode\":3,\"status\":-1,\"lat\":-1,\"lon\":-1,\"altHAE\":-1,"
                    + "\"track\":-1,\"speed\":-1,\"eph\":-1,\"epv\":-1}");
    assertThat(tpv.status()).isZero();
    assertThat(tpv.latitude()).as("a place").isEqualTo(-1);
    assertThat(tpv.height()).as("a height").isEqualTo(-1);
    assertThat(tpv.speed()).isNaN();
    assertThat(tpv.track()).isNaN();
    assertThat(tpv.horizontalError()).isNaN();
    assertThat(tpv.verticalError()).isNaN();
    assertThat(decode("{\"class\":\"SKY\",\"satellites\":[{\"PRN\":14,\"ss\":-2}]}"))
        .isEqualTo(new Malformed("SKY", "ss -2.0 is outside 0.0 to 1000.0"));
  }

  @Test
  void readsTheSky() {
    assertThat(
            decode(
                "{\"class\":\"SKY\",\"hdop\":0.9,\"pdop\":1.5,\"satellites\":[{\"PRN\":14,"
                    + "\"gnssid\":0,\"svid\":14,\"el\":41.0,\"az\":60.0,\"ss\":47.0,"
                    + "\"used\":true,\"health\":1},{\"PRN\":70,\"used\":false}]}"))
        .isEqualTo(
            new Sky(
                List.of(
                    new Satellite(14, 0, 14, 41, 60, 47, true),
                    new Satellite(70, -1, -1, Double.NaN, Double.NaN, Double.NaN, false)),
                1.5,
                0.9));
    assertThat(decode("{\"class\":\"SKY\",\"pdop\":1.5}"))
        .isEqualTo(new Sky(null, 1.5, Double.NaN));
  }

  @Test
  void readsWhatGpsdIsAndWhatItHas() {
    assertThat(decode("{\"class\":\"VERSION\",\"release\":\"3.22\",\"proto_major\":3}"))
        .isEqualTo(new Version("3.22"));
    assertThat(
            decode(
                "{\"class\":\"DEVICES\",\"devices\":[{\"class\":\"DEVICE\",\"path\":\"/dev/a\","
                    + "\"driver\":\"u-blox\",\"subtype\":\"SW 3.01\",\"bps\":9600}]}"))
        .isEqualTo(new Devices(List.of(new Device("/dev/a", "u-blox", "SW 3.01"))));
    assertThat(decode("{\"class\":\"WATCH\",\"enable\":true}")).isEqualTo(new Other("WATCH"));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "{\"class\":\"TPV\",\"mode\":\"three\"}",
        "{\"class\":\"TPV\",\"mode\":-1}",
        "{\"class\":\"TPV\",\"lat\":91}",
        "{\"class\":\"TPV\",\"lat\":1e400}",
        "{\"class\":\"TPV\",\"lat\":true}",
        "{\"class\":\"TPV\",\"time\":\"yesterday\"}",
        "{\"class\":\"TPV\",\"track\":361}",
        "{\"class\":\"TPV\" \"mode\":3}",
        "{\"class\":\"TPV\",}",
        "{\"class\":\"SKY\",\"satellites\":{}}",
        "{\"class\":\"SKY\",\"satellites\":[1]}",
        "{\"class\":\"X\",\"a\":[[[[[[[[[[1]]]]]]]]]]}",
        "{\"class\":\"X\",\"a\":11111111111111111111111111111111111111111111111111}",
      })
  void whatCannotBeIsMalformed(String line) {
    assertThat(decode(line)).isInstanceOf(Malformed.class);
  }

  private static GpsdMessage decode(String line) {
    List<GpsdMessage> found = GpsdParser.parse(Sentences.bytes(line + "\r\n"));
    assertThat(found).hasSize(1);
    return found.get(0);
  }
}
