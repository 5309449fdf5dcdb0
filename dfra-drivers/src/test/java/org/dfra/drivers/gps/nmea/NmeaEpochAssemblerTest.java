package org.dfra.drivers.gps.nmea;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.dfra.drivers.fixture.Sentences;
import org.dfra.drivers.gps.GpsReceiverProtocol.GpsSolution;
import org.dfra.drivers.gps.GpsReceiverProtocol.SatelliteInView;
import org.dfra.flow.sensor.GpsFix;
import org.junit.jupiter.api.Test;

class NmeaEpochAssemblerTest {

  private static final Instant HOST = Instant.parse("2026-11-21T00:00:10Z");
  private static final String GGA = "GNGGA,%s,4807.038,N,01131.0,E,1,08,0.9,545.4,M,46.9,M,,";
  private static final String RMC = "GNRMC,%s,A,4807.038,N,01131.0,E,10.0,84.4,211126,,,A";

  private final List<GpsSolution> reported = new ArrayList<>();
  private final NmeaEpochAssembler epoch = new NmeaEpochAssembler(() -> HOST, reported::add);
  private final NmeaParser parser = new NmeaParser(epoch::take);

  @Test
  void reportsAnEpochAsSoonAsBothSentencesAreThere() {
    receive("GNGSA,A,3,04,05,,,,,,,,,,,2.5,1.3,2.1");
    receive(RMC.formatted("120000.00"));
    assertThat(reported).isEmpty();
    receive(GGA.formatted("120000.00"));
    GpsFix fix = reported.get(0).fix();
    assertThat(fix.mode()).isEqualTo(GpsFix.Mode.FIX_3D);
    assertThat(fix.position().height()).isCloseTo(592.3, within(1e-9)); // 545.4 + 46.9
    assertThat(fix.utc()).isEqualTo("2026-11-21T12:00:00Z");
    assertThat(fix.speed()).isCloseTo(5.1444, within(1e-4));
    assertThat(fix.course()).isEqualTo(84.4);
    assertThat(fix.dilutionOfPrecision()).isEqualTo(2.5);
    assertThat(fix.satellitesTracked()).isEqualTo(8);
    assertThat(reported.get(0).utcUnconfirmedReason()).isNull();
    receive(GGA.formatted("120000.00"));
    assertThat(reported).as("an epoch is reported once").hasSize(1);
  }

  @Test
  void learnsThatAReceiverSendsOneSentenceOnly() {
    for (int second = 0; second < 5; second++) {
      receive(GGA.formatted("00001" + second));
    }
    assertThat(reported).hasSize(5);
    assertThat(reported.get(4).fix().utc()).as("the host's day").isEqualTo("2026-11-21T00:00:14Z");
    assertThat(reported.get(4).utcUnconfirmedReason())
        .isEqualTo("has not reported the date yet, which only RMC and ZDA do");
    receive(RMC.formatted("000015"));
    receive(GGA.formatted("000015"));
    assertThat(reported).as("and that it sends both after all").hasSize(6);
    assertThat(reported.get(5).utcUnconfirmedReason()).isNull();
  }

  @Test
  void rmcAloneGivesAFlatFix() {
    for (int second = 0; second < 3; second++) {
      receive(RMC.formatted("12000" + second));
    }
    assertThat(reported).hasSize(3);
    assertThat(reported.get(2).fix().mode()).isEqualTo(GpsFix.Mode.FIX_2D);
    assertThat(reported.get(2).fix().position().height()).isZero();
  }

  @Test
  void aLostSentenceDelaysItsMomentOnly() {
    receive(RMC.formatted("120000"));
    receive(GGA.formatted("120000"));
    receive(RMC.formatted("120001")); // its GGA is lost
    assertThat(reported).hasSize(1);
    receive(RMC.formatted("120002"));
    assertThat(reported).hasSize(2);
    assertThat(reported.get(1).fix().mode()).isEqualTo(GpsFix.Mode.FIX_2D);
    receive(GGA.formatted("120002"));
    assertThat(reported).hasSize(3);
    assertThat(reported.get(2).fix().mode()).isEqualTo(GpsFix.Mode.FIX_3D);
  }

  @Test
  void theHostsDayIsTheNearestOne() {
    receive(GGA.formatted("235959"));
    receive(GGA.formatted("000000"));
    assertThat(reported.get(0).fix().utc()).isEqualTo("2026-11-20T23:59:59Z");
  }

  @Test
  void aReceiverThatSearchesHasNoPosition() {
    receive("GPGSV,1,1,02,03,10,050,,04,45,090,31");
    for (int second = 0; second < 2; second++) {
      receive("GPRMC,,V,,,,,,,,,,N");
      receive("GPGGA,,,,,,0,00,99.99,,,,,,");
    }
    assertThat(reported).hasSize(2);
    assertThat(reported.get(0).fix().mode()).isEqualTo(GpsFix.Mode.NONE);
    assertThat(reported.get(0).state()).isEqualTo("searching for satellites, 1 of 2 tracked");
    assertThat(reported.get(0).utcUnconfirmedReason()).isEqualTo("has not reported the time yet");
  }

  @Test
  void whatIsEstimatedOrDoubtedIsNoPosition() {
    receive(RMC.formatted("120000"));
    receive(GGA.formatted("120000").replace(",E,1,", ",E,6,"));
    receive(RMC.formatted("120001").replace(",A,48", ",V,48"));
    receive(GGA.formatted("120001"));
    receive(RMC.formatted("120002"));
    receive(GGA.formatted("120002").replace(",E,1,", ",E,7,"));
    assertThat(reported)
        .extracting(solution -> solution.fix().mode())
        .containsExactly(GpsFix.Mode.NONE, GpsFix.Mode.NONE, GpsFix.Mode.POSITION_HOLD);
  }

  @Test
  void keepsSpeedAndCourseForTwoSecondsWhereGgaComesMoreOften() {
    for (int tenth = 0; tenth < 3; tenth++) {
      receive(GGA.formatted("12000%d.00".formatted(tenth))); // and learns that it need not wait
    }
    reported.clear();
    receive(RMC.formatted("120010.00"));
    receive(GGA.formatted("120010.00"));
    for (int fifth = 1; fifth <= 12; fifth++) {
      receive(GGA.formatted("1200%d.%d0".formatted(10 + fifth / 5, fifth % 5 * 2)));
    }
    // The first three without RMC wait for the next.
    List<GpsFix> fixes = reported.stream().map(GpsSolution::fix).toList();
    assertThat(fixes).hasSize(13);
    assertThat(fixes.subList(0, 11))
        .allSatisfy(fix -> assertThat(fix.speed()).isCloseTo(5.1444, within(1e-4)))
        .allSatisfy(fix -> assertThat(fix.course()).isEqualTo(84.4));
    assertThat(fixes.get(10).utc()).isEqualTo("2026-11-21T12:00:12Z");
    assertThat(fixes.subList(11, 13))
        .as("older than 2 s is unknown, not 0")
        .allSatisfy(fix -> assertThat(fix.speed()).isNaN())
        .allSatisfy(fix -> assertThat(fix.course()).isNaN());
  }

  @Test
  void speedAndCourseAreKeptAcrossMidnight() {
    receive(RMC.formatted("235959.00"));
    receive(GGA.formatted("235959.00"));
    for (int second = 0; second < 3; second++) {
      receive(GGA.formatted("00000%d.00".formatted(second)));
    }
    assertThat(reported)
        .extracting(solution -> Double.isNaN(solution.fix().speed()))
        .containsExactly(false, false, false, true);
  }

  @Test
  void aReceiverThatStandsByNothingHasNoSpeed() {
    receive(RMC.formatted("120000"));
    receive(GGA.formatted("120000"));
    receive(RMC.formatted("120001").replace(",A,48", ",V,48"));
    receive(GGA.formatted("120001"));
    receive(GGA.formatted("120002"));
    receive(GGA.formatted("120003"));
    assertThat(reported).hasSize(4);
    assertThat(reported.get(1).fix().speed()).isNaN();
    assertThat(reported.get(2).fix().speed()).as("not the old one again").isNaN();
  }

  @Test
  void takesSpeedAndCourseOfVtg() {
    for (int second = 0; second < 4; second++) {
      receive(GGA.formatted("12000" + second));
      receive("GNVTG,054.7,T,034.4,M,010.0,N,018.5,K,A");
    }
    GpsFix last = reported.get(reported.size() - 1).fix();
    assertThat(last.utc()).isEqualTo("2026-11-21T12:00:03Z"); // the host's nearest day
    assertThat(last.speed()).isCloseTo(5.1444, within(1e-4));
    assertThat(last.course()).isEqualTo(54.7);
    receive("GNVTG,,T,,M,,N,,K,N");
    receive(GGA.formatted("120004"));
    assertThat(reported.get(reported.size() - 1).fix().speed()).isNaN();
  }

  @Test
  void takesGnsForGga() {
    receive("GNRMC,120000,A,4807.038,N,01131.0,E,10.0,84.4,211126,,,A");
    receive("GNGNS,120000,4807.038,N,01131.0,E,AAN,14,0.9,545.4,46.9,,");
    receive("GPGNS,120000,,,,,,7,,,,,");
    receive(GGA.formatted("120000").replace("545.4", "9999"));
    assertThat(reported).hasSize(1);
    GpsFix fix = reported.get(0).fix();
    assertThat(fix.mode()).isEqualTo(GpsFix.Mode.FIX_3D);
    assertThat(fix.position().height()).isCloseTo(592.3, within(1e-9));
    assertThat(fix.satellitesTracked()).isEqualTo(14);
    assertThat(fix.dilutionOfPrecision()).isEqualTo(0.9);
    receive("GNRMC,120001,A,4807.038,N,01131.0,E,10.0,84.4,211126,,,A");
    receive("GNGNS,120001,4807.038,N,01131.0,E,NN,00,,,,,");
    assertThat(reported.get(1).fix().mode()).isEqualTo(GpsFix.Mode.NONE);
  }

  @Test
  void zdaGivesTheDateThatGgaLacks() {
    receive("GNZDA,235959.00,04,07,2026,00,00");
    for (String time : List.of("235959.00", "000000.00", "000001.00", "000002.00")) {
      receive(GGA.formatted(time));
    }
    GpsSolution last = reported.get(reported.size() - 1);
    assertThat(last.fix().utc()).as("the next day").isEqualTo("2026-07-05T00:00:02Z");
    assertThat(last.utcUnconfirmedReason()).isNull();
  }

  @Test
  void theDateGoesOnAtMidnightWhereRmcIsLate() {
    receive(RMC.formatted("235959"));
    receive(GGA.formatted("235959"));
    receive(GGA.formatted("000000"));
    receive(GGA.formatted("000001"));
    assertThat(reported.get(1).fix().utc()).isEqualTo("2026-11-22T00:00:00Z");
    assertThat(reported.get(1).utcUnconfirmedReason()).isNull();
  }

  @Test
  void withoutTheGeoidAFixIsFlat() {
    receive(RMC.formatted("120000"));
    receive(GGA.formatted("120000").replace("46.9", ""));
    assertThat(reported.get(0).fix().mode()).isEqualTo(GpsFix.Mode.FIX_2D);
  }

  @Test
  void putsTheSatellitesOfAllSystemsTogether() {
    receive("GNGSA,A,3,04,,,,,,,,,,,,2.5,1.3,2.1,1");
    receive("GNGSA,A,3,65,,,,,,,,,,,,2.5,1.3,2.1,2");
    receive("GPGSV,2,1,05,03,10,050,,04,45,090,31,08,20,180,20,40,30,200,25");
    receive("GPGSV,2,2,05,09,05,010,12");
    receive("GLGSV,1,1,01,65,50,300,40");
    assertThat(epoch.satellites())
        .containsExactly(
            new SatelliteInView("G03", 10, 50, null, false),
            new SatelliteInView("G04", 45, 90, 31, true),
            new SatelliteInView("G08", 20, 180, 20, false),
            new SatelliteInView("G09", 5, 10, 12, false),
            new SatelliteInView("R01", 50, 300, 40, true),
            new SatelliteInView("S27", 30, 200, 25, false));
    receive("GPGSV,2,1,01,03,11,050,"); // its second part is lost: the old ones stay
    receive("GPGSV,2,1,01,03,11,050,");
    assertThat(epoch.satellites()).hasSize(6);
  }

  private void receive(String body) {
    byte[] sentence = Sentences.with(body);
    parser.feed(sentence, 0, sentence.length);
  }
}
