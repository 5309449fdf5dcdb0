package org.dfra.drivers.gps.nmea;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.LocalDate;
import java.time.LocalTime;
import java.util.List;
import org.dfra.drivers.fixture.Sentences;
import org.dfra.drivers.gps.nmea.NmeaSentence.Gga;
import org.dfra.drivers.gps.nmea.NmeaSentence.Gns;
import org.dfra.drivers.gps.nmea.NmeaSentence.Gsa;
import org.dfra.drivers.gps.nmea.NmeaSentence.Gsv;
import org.dfra.drivers.gps.nmea.NmeaSentence.Malformed;
import org.dfra.drivers.gps.nmea.NmeaSentence.Other;
import org.dfra.drivers.gps.nmea.NmeaSentence.Rmc;
import org.dfra.drivers.gps.nmea.NmeaSentence.Satellite;
import org.dfra.drivers.gps.nmea.NmeaSentence.Vtg;
import org.dfra.drivers.gps.nmea.NmeaSentence.Zda;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class NmeaDecoderTest {

  @Test
  void readsRmc() {
    Rmc rmc = (Rmc) decode("GNRMC,123519.25,A,4807.038,N,01131.000,W,022.4,084.4,230394,003.1,W,D");
    assertThat(rmc.talker()).isEqualTo("GN");
    assertThat(rmc.time()).isEqualTo(LocalTime.of(12, 35, 19, 250_000_000));
    assertThat(rmc.valid()).isTrue();
    assertThat(rmc.latitude()).isCloseTo(48 + 7.038 / 60, within(1e-12));
    assertThat(rmc.longitude()).isCloseTo(-11 - 31.0 / 60, within(1e-12));
    assertThat(rmc.speed()).isCloseTo(11.5236, within(1e-4)); // 22.4 knots
    assertThat(rmc.course()).isEqualTo(84.4);
    assertThat(rmc.date()).isEqualTo(LocalDate.of(1994, 3, 23));
    assertThat(rmc.mode()).isEqualTo('D');
  }

  @Test
  void readsGga() {
    Gga gga = (Gga) decode("GPGGA,123519,4807.038,S,01131.000,E,2,08,0.9,545.4,M,46.9,M,,");
    assertThat(gga.time()).isEqualTo(LocalTime.of(12, 35, 19));
    assertThat(gga.latitude()).isCloseTo(-48 - 7.038 / 60, within(1e-12));
    assertThat(gga.longitude()).isCloseTo(11 + 31.0 / 60, within(1e-12));
    assertThat(gga.quality()).isEqualTo(2);
    assertThat(gga.used()).isEqualTo(8);
    assertThat(gga.dilution()).isEqualTo(0.9);
    assertThat(gga.altitude()).isEqualTo(545.4);
    assertThat(gga.separation()).isEqualTo(46.9);
  }

  @Test
  void emptyFieldsAreNoValues() {
    assertThat(decode("GPGGA,,,,,,0,,,,,,,,"))
        .isEqualTo(
            new Gga("GP", null, Double.NaN, Double.NaN, 0, -1, Double.NaN, Double.NaN, Double.NaN));
    assertThat(decode("GPRMC,,V,,,,,,,,,"))
        .isEqualTo(
            new Rmc("GP", null, false, Double.NaN, Double.NaN, Double.NaN, Double.NaN, null, ' '));
    assertThat(decode("GPGSA"))
        .as("cut right after its name")
        .isEqualTo(new Gsa("GP", -1, List.of(), Double.NaN, Double.NaN, Double.NaN, -1));
  }

  @Test
  void readsGsaOfOldAndNewReceivers() {
    assertThat(decode("GPGSA,A,3,04,05,,09,12,,,24,,,,,2.5,1.3,2.1"))
        .isEqualTo(new Gsa("GP", 3, List.of(4, 5, 9, 12, 24), 2.5, 1.3, 2.1, -1));
    assertThat(decode("GNGSA,A,3,81,82,,,,,,,,,,,1.5,0.9,1.2,2"))
        .isEqualTo(new Gsa("GN", 3, List.of(81, 82), 1.5, 0.9, 1.2, 2));
  }

  @Test
  void readsGsvOfOldAndNewReceivers() {
    assertThat(decode("GPGSV,3,3,09,30,05,120,"))
        .isEqualTo(new Gsv("GP", 3, 3, 9, List.of(new Satellite(30, 5, 120, -1)), -1));
    assertThat(decode("GAGSV,1,1,02,11,42,060,38,12,,,,7"))
        .isEqualTo(
            new Gsv(
                "GA",
                1,
                1,
                2,
                List.of(new Satellite(11, 42, 60, 38), new Satellite(12, -1, -1, -1)),
                7));
    assertThat(decode("GLGSV,1,1,00")).isEqualTo(new Gsv("GL", 1, 1, 0, List.of(), -1));
  }

  @Test
  void otherSentencesAreNamed() {
    assertThat(decode("GPGLL,4916.45,N,12311.12,W,225444,A")).isEqualTo(new Other("GP", "GLL"));
    assertThat(decode("PUBX,00,1")).isEqualTo(new Other("", "PUBX"));
  }

  @Test
  void readsGns() {
    Gns gns =
        (Gns) decode("GNGNS,122310.2,3722.425671,N,12258.856215,W,DAN,14,0.9,1005.543,6.5,5.2,23");
    assertThat(gns.talker()).isEqualTo("GN");
    assertThat(gns.time()).isEqualTo(LocalTime.of(12, 23, 10, 200_000_000));
    assertThat(gns.latitude()).isCloseTo(37 + 22.425671 / 60, within(1e-12));
    assertThat(gns.longitude()).isCloseTo(-122 - 58.856215 / 60, within(1e-12));
    assertThat(gns.modes()).isEqualTo("DAN");
    assertThat(gns.quality()).as("the best: differential").isEqualTo(2);
    assertThat(gns.used()).isEqualTo(14);
    assertThat(gns.dilution()).isEqualTo(0.9);
    assertThat(gns.altitude()).isEqualTo(1005.543);
    assertThat(gns.separation()).isEqualTo(6.5);
    assertThat(((Gns) decode("GPGNS,122310.2,,,,,,7,,,,5.2,23")).modes()).isEmpty();
  }

  @ParameterizedTest
  @CsvSource({
    "NN, 0", "AN, 1", "NA, 1", "AD, 2", "P, 3", "RA, 4", "AF, 5", "EN, 6", "MN, 7", "SN, 8", "X, 0"
  })
  void theBestSystemGivesTheQualityOfGns(String modes, int quality) {
    assertThat(((Gns) decode("GNGNS,122310,,,,," + modes + ",14,,,,,")).quality())
        .isEqualTo(quality);
  }

  @Test
  void readsVtgOfOldAndNewReceivers() {
    Vtg vtg = (Vtg) decode("GNVTG,054.7,T,034.4,M,005.5,N,010.2,K,D");
    assertThat(vtg.course()).isEqualTo(54.7);
    assertThat(vtg.speed()).isCloseTo(5.5 * 1852 / 3600, within(1e-9));
    assertThat(vtg.mode()).isEqualTo('D');
    assertThat(((Vtg) decode("GPVTG,,T,,M,,N,7.2,K")).speed()).isCloseTo(2, within(1e-9));
    assertThat(((Vtg) decode("GPVTG,054.7,034.4,005.5,010.2")).speed())
        .isCloseTo(5.5 * 1852 / 3600, within(1e-9));
    assertThat(decode("GPVTG,,,,,,,,,N")).isEqualTo(new Vtg("GP", Double.NaN, Double.NaN, 'N'));
  }

  @Test
  void readsZdaWithItsZone() {
    assertThat(decode("GNZDA,201530.00,04,07,2002,00,00"))
        .isEqualTo(new Zda("GN", LocalTime.of(20, 15, 30), LocalDate.of(2002, 7, 4), 0));
    assertThat(decode("GPZDA,201530,04,07,2002,-05,30"))
        .isEqualTo(new Zda("GP", LocalTime.of(20, 15, 30), LocalDate.of(2002, 7, 4), -330));
    assertThat(((Zda) decode("GPZDA,201530,04,07,2002,-00,30")).localZone()).isEqualTo(-30);
    assertThat(decode("GPZDA,,,,,,")).isEqualTo(new Zda("GP", null, null, null));
    assertThat(((Zda) decode("GPZDA,000001,00,00,0000,,")).date()).isNull();
    assertThat(decode("GPZDA,201530,31,06,2002,00,00"))
        .isEqualTo(
            new Malformed("GP", "ZDA", "day \"31\" in field 2 is not a day of month 6 of 2002"));
  }

  @ParameterizedTest
  @ValueSource(strings = {"GP", "GN", "GL", "GA", "GB", "BD", "GQ", "QZ", "GI", "IN"})
  void readsEveryTalker(String talker) {
    for (String body :
        List.of(
            "RMC,,V,,,,,,,,,,N",
            "GGA,,,,,,0,,,,,,,,",
            "GNS,,,,,,NN,,,,,,",
            "VTG,,T,,M,,N,,K,N",
            "ZDA,,,,,,")) {
      NmeaSentence sentence = decode(talker + body);
      assertThat(sentence.talker()).isEqualTo(talker);
      assertThat(sentence).isNotInstanceOfAny(Other.class, Malformed.class);
    }
  }

  @Test
  void aDateOfZerosIsUnknown() {
    assertThat(((Rmc) decode("GPRMC,,V,,,,,,,000000,,,N")).date()).isNull();
  }

  @Test
  void aLeapSecondIsTheEndOfTheMinuteBefore() {
    assertThat(((Gga) decode("GPGGA,235960.00,,,,,0,,,,,,,,")).time())
        .isEqualTo(LocalTime.of(23, 59, 59, 999_999_999));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "GPGGA,123519,9007.0,N,,,1,,,,,,,, | latitude \"9007.0\" in field 2 is not a number from 0.0"
            + " to 9000.0",
        "GPGGA,123519,4867.0,N,,,1,,,,,,,, | latitude \"4867.0\" in field 2 is not degrees and minutes",
        "GPGGA,126519,,,,,1,,,,,,,, | time \"126519\" in field 1 is not a time of day",
        "GPGGA,12x519,,,,,1,,,,,,,, | time \"12x519\" in field 1 is not a number",
        "GPGGA,,,,,,A,,,,,,,, | quality \"A\" in field 6 is not a whole number",
        "GPGGA,,,,,,1,,,9999999999999999999999,,,,, | altitude (m) \"9999999999999999999999\" in field"
            + " 9 is not a number",
        "GPRMC,,A,,,,,,361,,, | course (°) \"361\" in field 8 is not a number from 0.0 to 360.0",
        "GPRMC,,A,,,,,,,310226,, | date \"310226\" in field 9 is not a date",
        "GPGSV,1,1,01,30,95,, | elevation (°) \"95\" in field 5 is not a whole number from 0 to 90",
      })
  void aValueThatCannotBeMakesAMalformedSentence(String body, String reason) {
    assertThat(decode(body)).isEqualTo(new Malformed("GP", body.substring(2, 5), reason));
  }

  private static NmeaSentence decode(String body) {
    List<NmeaSentence> found = NmeaParser.parse(Sentences.with(body));
    assertThat(found).hasSize(1);
    return found.get(0);
  }
}
