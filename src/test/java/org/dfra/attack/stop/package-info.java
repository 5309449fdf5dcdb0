/** Fake drives that try to prevent or to fake the stop of a robot. */
package org.dfra.attack.stop;
