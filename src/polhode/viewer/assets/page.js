/* three.js: The MIT License

Copyright © 2010-2026 three.js authors

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.

The rest is part of polhode, under the MIT licence. */
(()=>{var fv=Object.defineProperty;var ps=(n,e)=>{for(var t in e)fv(n,t,{get:e[t],enumerable:!0})};var sl=`zero or of a size from ${1e-100} to ${1e100}`,Ch=n=>n===0||typeof n=="number"&&Math.abs(n)>=1/1e100&&Math.abs(n)<=1e100;function Pn(n){let e=String(JSON.stringify(n,(t,i)=>typeof i=="number"&&!Number.isFinite(i)?String(i):i));return e.length>60?`${e.slice(0,60)}\u2026`:e}function Ih(n,e,t,i=""){if(Object.hasOwn(n,e))return n[e];throw new RangeError(`There is no ${t} ${(i+e).slice(0,60)} here; there are ${Object.keys(n).join(", ")}.`)}function zp(n){let e=[];for(let[t,i]of Object.entries(n))if(typeof i!="object")e.push(`${t}=${kp(i)}`);else for(let[s,r]of Object.entries(i))e.push(`${t}.${s}=${kp(r)}`);return e.join("&")}var kp=n=>[n].flat().map(e=>typeof e=="number"?String(e):encodeURIComponent(e)).join(",");function rl(n){let e=Object.create(null),t=[];for(let i of n.replace(/^#/,"").split("&").filter(Boolean))try{pv(e,i)}catch(s){t.push(s)}return{tables:e,refused:t}}function pv(n,e){let[t,...i]=e.split("="),[s,r,...o]=t.split(".");if(!s||r===""||o.length)throw new RangeError(`The link must name what it sets, as in spin.rate=2; got ${Pn(e)}. Leave that out.`);let a=mv(t,i.join("="));if(r===void 0){n[s]=a;return}let l=n[s]??=Object.create(null);if(typeof l!="object"||Array.isArray(l))throw new RangeError(`${s} must be a value or a table; got both in the link. Leave out ${s}, or ${Pn(t)}.`);l[r]=a}function mv(n,e){let t;try{t=decodeURIComponent(e)}catch{throw new RangeError(`${n.slice(0,60)} must have whole escapes like %20; got ${Pn(e)}. Write the value without %.`)}let i=t.split(",").map(r=>r.trim()===""?NaN:Number(r));if(i.length===1&&!Number.isFinite(i[0]))return t;if(i.every(Ch))return i.length===1?i[0]:i;let s=i.length===1?"":"numbers between commas, each ";throw new RangeError(`${n.slice(0,60)} must be ${s}${sl}; got ${Pn(t)}. Check the number, which is in SI units.`)}var gv=300,ol=class{constructor(e,t){this.seen=e,window.addEventListener("hashchange",()=>{window.location.hash.slice(1)!==this.fragment&&t(this.read())})}read(){return rl(window.location.hash)}get fragment(){return zp(this.seen())}get whole(){let{protocol:e,href:t}=window.location;if(e==="about:")return null;let i=this.fragment;return t.split("#")[0]+(i?`#${i}`:"")}changed(){clearTimeout(this.waiting),this.waiting=setTimeout(()=>this.write(),gv)}write(){clearTimeout(this.waiting);let{whole:e}=this;if(!(e===null||e===window.location.href))try{window.history.replaceState(null,"",e)}catch{}}};var bm=0,ld=1,Sm=2;var ma=1,wm=2,Zr=3,Ts=0,Mn=1,Ti=2,sr=0,jr=1,cd=2,ud=3,hd=4,Am=5;var rr=100,Em=101,Tm=102,Rm=103,Cm=104,Im=200,Pm=201,Lm=202,Nm=203,dd=204,fd=205,Dm=206,Um=207,Fm=208,Om=209,Bm=210,km=211,zm=212,Gm=213,Vm=214,Bl=0,kl=1,zl=2,Or=3,Gl=4,Vl=5,Hl=6,Wl=7,ga=0,Hm=1,Wm=2,Ri=0,pd=1,md=2,gd=3,xd=4,yd=5,_d=6,vd=7;var Md=300,or=301,Kr=302,gc=303,xc=304,ql=1e3,wi=1001,Xl=1002,Xt=1003,qm=1004;var xa=1005;var Ft=1006,yc=1007;var Ji=1008;var Dn=1009,bd=1010,Sd=1011,Jr=1012,_c=1013,pi=1014,ii=1015,mi=1016,vc=1017,Mc=1018,ar=1020,wd=35902,Ad=35899,Ed=1021,Td=1022,gi=1023,Zi=1026,Qi=1027,bc=1028,Sc=1029,Rs=1030,wc=1031;var Ac=1033,ya=33776,_a=33777,va=33778,Ma=33779,Ec=35840,Tc=35841,Rc=35842,Cc=35843,Ic=36196,Pc=37492,Lc=37496,Nc=37488,Dc=37489,ba=37490,Uc=37491,Fc=37808,Oc=37809,Bc=37810,kc=37811,zc=37812,Gc=37813,Vc=37814,Hc=37815,Wc=37816,qc=37817,Xc=37818,$c=37819,Yc=37820,Zc=37821,jc=36492,Kc=36494,Jc=36495,Qc=36283,eu=36284,Sa=36285,tu=36286;var zo=2300,$l=2301,Fl=2302,ed=2303,td=2400,nd=2401,id=2402;var Xm=3200;var Qr=0,$m=1,es="",Bn="srgb",Go="srgb-linear",Vo="linear",st="srgb";var Ol=7680;var Ym=519,Zm=512,jm=513,Km=514,Rd=515,Jm=516,Qm=517,Cd=518,Id=519,Pd=35044;var Ld="300 es",Qn=2e3,Br=2001;function xv(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function yv(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function Ho(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function eg(){let n=Ho("canvas");return n.style.display="block",n}var Gp={},kr=null;function Wo(...n){let e="THREE."+n.shift();kr?kr("log",e,...n):console.log(e,...n)}function tg(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Ie(...n){n=tg(n);let e="THREE."+n.shift();if(kr)kr("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function Ue(...n){n=tg(n);let e="THREE."+n.shift();if(kr)kr("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function Bo(...n){let e=n.join(" ");e in Gp||(Gp[e]=!0,Ie(...n))}function ng(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}var ig={[Bl]:Bl,[zl]:Hl,[Gl]:Gl,[Or]:Vl,[kl]:kl,[Hl]:zl,[Wl]:Wl,[Vl]:Or},Ai=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},un=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Vp=1234567,Ur=Math.PI/180,zr=180/Math.PI;function Cs(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(un[n&255]+un[n>>8&255]+un[n>>16&255]+un[n>>24&255]+"-"+un[e&255]+un[e>>8&255]+"-"+un[e>>16&15|64]+un[e>>24&255]+"-"+un[t&63|128]+un[t>>8&255]+"-"+un[t>>16&255]+un[t>>24&255]+un[i&255]+un[i>>8&255]+un[i>>16&255]+un[i>>24&255]).toLowerCase()}function Ve(n,e,t){return Math.max(e,Math.min(t,n))}function Nd(n,e){return(n%e+e)%e}function _v(n,e,t,i,s){return i+(n-e)*(s-i)/(t-e)}function vv(n,e,t){return n!==e?(t-n)/(e-n):0}function ko(n,e,t){return(1-t)*n+t*e}function Mv(n,e,t,i){return ko(n,e,1-Math.exp(-t*i))}function bv(n,e=1){return e-Math.abs(Nd(n,e*2)-e)}function Sv(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*(3-2*n))}function wv(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*n*(n*(n*6-15)+10))}function Av(n,e){return n+Math.floor(Math.random()*(e-n+1))}function Ev(n,e){return n+Math.random()*(e-n)}function Tv(n){return n*(.5-Math.random())}function Rv(n){n!==void 0&&(Vp=n);let e=Vp+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function Cv(n){return n*Ur}function Iv(n){return n*zr}function Pv(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function Lv(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function Dd(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function Nv(n,e,t,i,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+i)/2),u=o((e+i)/2),h=r((e-i)/2),d=o((e-i)/2),f=r((i-e)/2),p=o((i-e)/2);switch(s){case"XYX":n.set(a*u,l*h,l*d,a*c);break;case"YZY":n.set(l*d,a*u,l*h,a*c);break;case"ZXZ":n.set(l*h,l*d,a*u,a*c);break;case"XZX":n.set(a*u,l*p,l*f,a*c);break;case"YXY":n.set(l*f,a*u,l*p,a*c);break;case"ZYZ":n.set(l*p,l*f,a*u,a*c);break;default:Ie("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function nu(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Ud(n,e){if(e.constructor===Float32Array)return n;let t=nu(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function Fd(n,e){if(e.constructor===Float32Array)return n;let t=nu(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var iu={DEG2RAD:Ur,RAD2DEG:zr,generateUUID:Cs,clamp:Ve,euclideanModulo:Nd,mapLinear:_v,inverseLerp:vv,lerp:ko,damp:Mv,pingpong:bv,smoothstep:Sv,smootherstep:wv,randInt:Av,randFloat:Ev,randFloatSpread:Tv,seededRandom:Rv,degToRad:Cv,radToDeg:Iv,isPowerOfTwo:Pv,ceilPowerOfTwo:Lv,floorPowerOfTwo:Dd,setQuaternionFromProperEuler:Nv,normalize:Fd,denormalize:Ud},Ge=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=Ve(this.x,e.x,t.x),this.y=Ve(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=Ve(this.x,e,t),this.y=Ve(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Ve(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(Ve(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},rt=class{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],h=i[s+3],d=r[o+0],f=r[o+1],p=r[o+2],x=r[o+3];if(h!==x||l!==d||c!==f||u!==p){let m=l*d+c*f+u*p+h*x;m<0&&(d=-d,f=-f,p=-p,x=-x,m=-m);let g=1-a;if(m<.9995){let y=Math.acos(m),v=Math.sin(y);g=Math.sin(g*y)/v,a=Math.sin(a*y)/v,l=l*g+d*a,c=c*g+f*a,u=u*g+p*a,h=h*g+x*a}else{l=l*g+d*a,c=c*g+f*a,u=u*g+p*a,h=h*g+x*a;let y=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=y,c*=y,u*=y,h*=y}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h}static multiplyQuaternionsFlat(e,t,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],h=r[o],d=r[o+1],f=r[o+2],p=r[o+3];return e[t]=a*p+u*h+l*f-c*d,e[t+1]=l*p+u*d+c*h-a*f,e[t+2]=c*p+u*f+a*d-l*h,e[t+3]=u*p-a*h-l*d-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),h=a(r/2),d=l(i/2),f=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=d*u*h+c*f*p,this._y=c*f*h-d*u*p,this._z=c*u*p+d*f*h,this._w=c*u*h-d*f*p;break;case"YXZ":this._x=d*u*h+c*f*p,this._y=c*f*h-d*u*p,this._z=c*u*p-d*f*h,this._w=c*u*h+d*f*p;break;case"ZXY":this._x=d*u*h-c*f*p,this._y=c*f*h+d*u*p,this._z=c*u*p+d*f*h,this._w=c*u*h-d*f*p;break;case"ZYX":this._x=d*u*h-c*f*p,this._y=c*f*h+d*u*p,this._z=c*u*p-d*f*h,this._w=c*u*h+d*f*p;break;case"YZX":this._x=d*u*h+c*f*p,this._y=c*f*h+d*u*p,this._z=c*u*p-d*f*h,this._w=c*u*h-d*f*p;break;case"XZY":this._x=d*u*h-c*f*p,this._y=c*f*h-d*u*p,this._z=c*u*p+d*f*h,this._w=c*u*h+d*f*p;break;default:Ie("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],h=t[10],d=i+a+h;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(u-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(i>a&&i>h){let f=2*Math.sqrt(1+i-a-h);this._w=(u-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>h){let f=2*Math.sqrt(1+a-i-h);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+u)/f}else{let f=2*Math.sqrt(1+h-i-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+u)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(Ve(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},C=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Hp.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Hp.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),u=2*(a*t-r*s),h=2*(r*i-o*t);return this.x=t+l*c+o*h-a*u,this.y=i+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=Ve(this.x,e.x,t.x),this.y=Ve(this.y,e.y,t.y),this.z=Ve(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=Ve(this.x,e,t),this.y=Ve(this.y,e,t),this.z=Ve(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Ve(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return Ph.copy(this).projectOnVector(e),this.sub(Ph)}reflect(e){return this.sub(Ph.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(Ve(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Ph=new C,Hp=new rt,Oe=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c)}set(e,t,i,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],h=i[7],d=i[2],f=i[5],p=i[8],x=s[0],m=s[3],g=s[6],y=s[1],v=s[4],M=s[7],w=s[2],E=s[5],_=s[8];return r[0]=o*x+a*y+l*w,r[3]=o*m+a*v+l*E,r[6]=o*g+a*M+l*_,r[1]=c*x+u*y+h*w,r[4]=c*m+u*v+h*E,r[7]=c*g+u*M+h*_,r[2]=d*x+f*y+p*w,r[5]=d*m+f*v+p*E,r[8]=d*g+f*M+p*_,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=u*o-a*c,d=a*l-u*r,f=c*r-o*l,p=t*h+i*d+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let x=1/p;return e[0]=h*x,e[1]=(s*c-u*i)*x,e[2]=(a*i-s*o)*x,e[3]=d*x,e[4]=(u*t-s*l)*x,e[5]=(s*r-a*t)*x,e[6]=f*x,e[7]=(i*l-c*t)*x,e[8]=(o*t-i*r)*x,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return Bo("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Lh.makeScale(e,t)),this}rotate(e){return Bo("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Lh.makeRotation(-e)),this}translate(e,t){return Bo("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Lh.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Lh=new Oe,Wp=new Oe().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),qp=new Oe().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Dv(){let n={enabled:!0,workingColorSpace:Go,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===st&&(s.r=Yi(s.r),s.g=Yi(s.g),s.b=Yi(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===st&&(s.r=Fr(s.r),s.g=Fr(s.g),s.b=Fr(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===es?Vo:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Go]:{primaries:e,whitePoint:i,transfer:Vo,toXYZ:Wp,fromXYZ:qp,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Bn},outputColorSpaceConfig:{drawingBufferColorSpace:Bn}},[Bn]:{primaries:e,whitePoint:i,transfer:st,toXYZ:Wp,fromXYZ:qp,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Bn}}}),n}var Je=Dv();function Yi(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Fr(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var _r,Yl=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{_r===void 0&&(_r=Ho("canvas")),_r.width=e.width,_r.height=e.height;let s=_r.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=_r}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Ho("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Yi(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(Yi(t[i]/255)*255):t[i]=Yi(t[i]);return{data:t,width:e.width,height:e.height}}else return Ie("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},Uv=0,Gr=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Uv++}),this.uuid=Cs(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Nh(s[o].image)):r.push(Nh(s[o]))}else r=Nh(s);i.url=r}return t||(e.images[this.uuid]=i),i}};function Nh(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Yl.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Ie("Texture: Unable to serialize Texture."),{})}var Fv=0,Dh=new C,Ln=class n extends Ai{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=wi,s=wi,r=Ft,o=Ji,a=gi,l=Dn,c=n.DEFAULT_ANISOTROPY,u=es){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Fv++}),this.uuid=Cs(),this.name="",this.source=new Gr(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Ge(0,0),this.repeat=new Ge(1,1),this.center=new Ge(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Oe,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Dh).x}get height(){return this.source.getSize(Dh).y}get depth(){return this.source.getSize(Dh).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){Ie(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ie(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Md)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case ql:e.x=e.x-Math.floor(e.x);break;case wi:e.x=e.x<0?0:1;break;case Xl:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case ql:e.y=e.y-Math.floor(e.y);break;case wi:e.y=e.y<0?0:1;break;case Xl:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};Ln.DEFAULT_IMAGE=null;Ln.DEFAULT_MAPPING=Md;Ln.DEFAULT_ANISOTROPY=1;var ot=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r,l=e.elements,c=l[0],u=l[4],h=l[8],d=l[1],f=l[5],p=l[9],x=l[2],m=l[6],g=l[10];if(Math.abs(u-d)<.01&&Math.abs(h-x)<.01&&Math.abs(p-m)<.01){if(Math.abs(u+d)<.1&&Math.abs(h+x)<.1&&Math.abs(p+m)<.1&&Math.abs(c+f+g-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let v=(c+1)/2,M=(f+1)/2,w=(g+1)/2,E=(u+d)/4,_=(h+x)/4,b=(p+m)/4;return v>M&&v>w?v<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(v),s=E/i,r=_/i):M>w?M<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(M),i=E/s,r=b/s):w<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(w),i=_/r,s=b/r),this.set(i,s,r,t),this}let y=Math.sqrt((m-p)*(m-p)+(h-x)*(h-x)+(d-u)*(d-u));return Math.abs(y)<.001&&(y=1),this.x=(m-p)/y,this.y=(h-x)/y,this.z=(d-u)/y,this.w=Math.acos((c+f+g-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=Ve(this.x,e.x,t.x),this.y=Ve(this.y,e.y,t.y),this.z=Ve(this.z,e.z,t.z),this.w=Ve(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=Ve(this.x,e,t),this.y=Ve(this.y,e,t),this.z=Ve(this.z,e,t),this.w=Ve(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Ve(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Zl=class extends Ai{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Ft,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new ot(0,0,e,t),this.scissorTest=!1,this.viewport=new ot(0,0,e,t),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new Ln({width:e,height:t,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Ft,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Gr(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},kn=class extends Zl{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},qo=class extends Ln{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=Xt,this.minFilter=Xt,this.wrapR=wi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var jl=class extends Ln{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=Xt,this.minFilter=Xt,this.wrapR=wi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var Qe=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,s,r,o,a,l,c,u,h,d,f,p,x,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c,u,h,d,f,p,x,m)}set(e,t,i,s,r,o,a,l,c,u,h,d,f,p,x,m){let g=this.elements;return g[0]=e,g[4]=t,g[8]=i,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=l,g[2]=c,g[6]=u,g[10]=h,g[14]=d,g[3]=f,g[7]=p,g[11]=x,g[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,s=1/vr.setFromMatrixColumn(e,0).length(),r=1/vr.setFromMatrixColumn(e,1).length(),o=1/vr.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(e.order==="XYZ"){let d=o*u,f=o*h,p=a*u,x=a*h;t[0]=l*u,t[4]=-l*h,t[8]=c,t[1]=f+p*c,t[5]=d-x*c,t[9]=-a*l,t[2]=x-d*c,t[6]=p+f*c,t[10]=o*l}else if(e.order==="YXZ"){let d=l*u,f=l*h,p=c*u,x=c*h;t[0]=d+x*a,t[4]=p*a-f,t[8]=o*c,t[1]=o*h,t[5]=o*u,t[9]=-a,t[2]=f*a-p,t[6]=x+d*a,t[10]=o*l}else if(e.order==="ZXY"){let d=l*u,f=l*h,p=c*u,x=c*h;t[0]=d-x*a,t[4]=-o*h,t[8]=p+f*a,t[1]=f+p*a,t[5]=o*u,t[9]=x-d*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let d=o*u,f=o*h,p=a*u,x=a*h;t[0]=l*u,t[4]=p*c-f,t[8]=d*c+x,t[1]=l*h,t[5]=x*c+d,t[9]=f*c-p,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let d=o*l,f=o*c,p=a*l,x=a*c;t[0]=l*u,t[4]=x-d*h,t[8]=p*h+f,t[1]=h,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=f*h+p,t[10]=d-x*h}else if(e.order==="XZY"){let d=o*l,f=o*c,p=a*l,x=a*c;t[0]=l*u,t[4]=-h,t[8]=c*u,t[1]=d*h+x,t[5]=o*u,t[9]=f*h-p,t[2]=p*h-f,t[6]=a*u,t[10]=x*h+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(Ov,e,Bv)}lookAt(e,t,i){let s=this.elements;return Fn.subVectors(e,t),Fn.lengthSq()===0&&(Fn.z=1),Fn.normalize(),ms.crossVectors(i,Fn),ms.lengthSq()===0&&(Math.abs(i.z)===1?Fn.x+=1e-4:Fn.z+=1e-4,Fn.normalize(),ms.crossVectors(i,Fn)),ms.normalize(),al.crossVectors(Fn,ms),s[0]=ms.x,s[4]=al.x,s[8]=Fn.x,s[1]=ms.y,s[5]=al.y,s[9]=Fn.y,s[2]=ms.z,s[6]=al.z,s[10]=Fn.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],h=i[5],d=i[9],f=i[13],p=i[2],x=i[6],m=i[10],g=i[14],y=i[3],v=i[7],M=i[11],w=i[15],E=s[0],_=s[4],b=s[8],I=s[12],T=s[1],L=s[5],D=s[9],B=s[13],P=s[2],O=s[6],H=s[10],V=s[14],ee=s[3],X=s[7],j=s[11],te=s[15];return r[0]=o*E+a*T+l*P+c*ee,r[4]=o*_+a*L+l*O+c*X,r[8]=o*b+a*D+l*H+c*j,r[12]=o*I+a*B+l*V+c*te,r[1]=u*E+h*T+d*P+f*ee,r[5]=u*_+h*L+d*O+f*X,r[9]=u*b+h*D+d*H+f*j,r[13]=u*I+h*B+d*V+f*te,r[2]=p*E+x*T+m*P+g*ee,r[6]=p*_+x*L+m*O+g*X,r[10]=p*b+x*D+m*H+g*j,r[14]=p*I+x*B+m*V+g*te,r[3]=y*E+v*T+M*P+w*ee,r[7]=y*_+v*L+M*O+w*X,r[11]=y*b+v*D+M*H+w*j,r[15]=y*I+v*B+M*V+w*te,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],h=e[6],d=e[10],f=e[14],p=e[3],x=e[7],m=e[11],g=e[15],y=l*f-c*d,v=a*f-c*h,M=a*d-l*h,w=o*f-c*u,E=o*d-l*u,_=o*h-a*u;return t*(x*y-m*v+g*M)-i*(p*y-m*w+g*E)+s*(p*v-x*w+g*_)-r*(p*M-x*E+m*_)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=e[9],d=e[10],f=e[11],p=e[12],x=e[13],m=e[14],g=e[15],y=t*a-i*o,v=t*l-s*o,M=t*c-r*o,w=i*l-s*a,E=i*c-r*a,_=s*c-r*l,b=u*x-h*p,I=u*m-d*p,T=u*g-f*p,L=h*m-d*x,D=h*g-f*x,B=d*g-f*m,P=y*B-v*D+M*L+w*T-E*I+_*b;if(P===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let O=1/P;return e[0]=(a*B-l*D+c*L)*O,e[1]=(s*D-i*B-r*L)*O,e[2]=(x*_-m*E+g*w)*O,e[3]=(d*E-h*_-f*w)*O,e[4]=(l*T-o*B-c*I)*O,e[5]=(t*B-s*T+r*I)*O,e[6]=(m*M-p*_-g*v)*O,e[7]=(u*_-d*M+f*v)*O,e[8]=(o*D-a*T+c*b)*O,e[9]=(i*T-t*D-r*b)*O,e[10]=(p*E-x*M+g*y)*O,e[11]=(h*M-u*E-f*y)*O,e[12]=(a*I-o*L-l*b)*O,e[13]=(t*L-i*I+s*b)*O,e[14]=(x*v-p*w-m*y)*O,e[15]=(u*w-h*v+d*y)*O,this}scale(e){let t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,h=a+a,d=r*c,f=r*u,p=r*h,x=o*u,m=o*h,g=a*h,y=l*c,v=l*u,M=l*h,w=i.x,E=i.y,_=i.z;return s[0]=(1-(x+g))*w,s[1]=(f+M)*w,s[2]=(p-v)*w,s[3]=0,s[4]=(f-M)*E,s[5]=(1-(d+g))*E,s[6]=(m+y)*E,s[7]=0,s[8]=(p+v)*_,s[9]=(m-y)*_,s[10]=(1-(d+x))*_,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let o=vr.set(s[0],s[1],s[2]).length(),a=vr.set(s[4],s[5],s[6]).length(),l=vr.set(s[8],s[9],s[10]).length();r<0&&(o=-o),li.copy(this);let c=1/o,u=1/a,h=1/l;return li.elements[0]*=c,li.elements[1]*=c,li.elements[2]*=c,li.elements[4]*=u,li.elements[5]*=u,li.elements[6]*=u,li.elements[8]*=h,li.elements[9]*=h,li.elements[10]*=h,t.setFromRotationMatrix(li),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,s,r,o,a=Qn,l=!1){let c=this.elements,u=2*r/(t-e),h=2*r/(i-s),d=(t+e)/(t-e),f=(i+s)/(i-s),p,x;if(l)p=r/(o-r),x=o*r/(o-r);else if(a===Qn)p=-(o+r)/(o-r),x=-2*o*r/(o-r);else if(a===Br)p=-o/(o-r),x=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=h,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=x,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=Qn,l=!1){let c=this.elements,u=2/(t-e),h=2/(i-s),d=-(t+e)/(t-e),f=-(i+s)/(i-s),p,x;if(l)p=1/(o-r),x=o/(o-r);else if(a===Qn)p=-2/(o-r),x=-(o+r)/(o-r);else if(a===Br)p=-1/(o-r),x=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=h,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=p,c[14]=x,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},vr=new C,li=new Qe,Ov=new C(0,0,0),Bv=new C(1,1,1),ms=new C,al=new C,Fn=new C,Xp=new Qe,$p=new rt,Ei=class n{constructor(e=0,t=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],d=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(Ve(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-Ve(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(Ve(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-h,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-Ve(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(Ve(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-Ve(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,f),this._y=0);break;default:Ie("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return Xp.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Xp,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return $p.setFromEuler(this),this.setFromQuaternion($p,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Ei.DEFAULT_ORDER="XYZ";var Xo=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},kv=0,Yp=new C,Mr=new rt,Vi=new Qe,ll=new C,Po=new C,zv=new C,Gv=new rt,Zp=new C(1,0,0),jp=new C(0,1,0),Kp=new C(0,0,1),Jp={type:"added"},Vv={type:"removed"},br={type:"childadded",child:null},Uh={type:"childremoved",child:null},tn=class n extends Ai{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:kv++}),this.uuid=Cs(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new C,t=new Ei,i=new rt,s=new C(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Qe},normalMatrix:{value:new Oe}}),this.matrix=new Qe,this.matrixWorld=new Qe,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Xo,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Mr.setFromAxisAngle(e,t),this.quaternion.multiply(Mr),this}rotateOnWorldAxis(e,t){return Mr.setFromAxisAngle(e,t),this.quaternion.premultiply(Mr),this}rotateX(e){return this.rotateOnAxis(Zp,e)}rotateY(e){return this.rotateOnAxis(jp,e)}rotateZ(e){return this.rotateOnAxis(Kp,e)}translateOnAxis(e,t){return Yp.copy(e).applyQuaternion(this.quaternion),this.position.add(Yp.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(Zp,e)}translateY(e){return this.translateOnAxis(jp,e)}translateZ(e){return this.translateOnAxis(Kp,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Vi.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?ll.copy(e):ll.set(e,t,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Po.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Vi.lookAt(Po,ll,this.up):Vi.lookAt(ll,Po,this.up),this.quaternion.setFromRotationMatrix(Vi),s&&(Vi.extractRotation(s.matrixWorld),Mr.setFromRotationMatrix(Vi),this.quaternion.premultiply(Mr.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(Ue("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Jp),br.child=e,this.dispatchEvent(br),br.child=null):Ue("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(Vv),Uh.child=e,this.dispatchEvent(Uh),Uh.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Vi.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Vi.multiply(e.parent.matrixWorld)),e.applyMatrix4(Vi),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Jp),br.child=e,this.dispatchEvent(br),br.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Po,e,zv),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Po,Gv,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(e.shapes,h)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),h=o(e.shapes),d=o(e.skeletons),f=o(e.animations),p=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),d.length>0&&(i.skeletons=d),f.length>0&&(i.animations=f),p.length>0&&(i.nodes=p)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};tn.DEFAULT_UP=new C(0,1,0);tn.DEFAULT_MATRIX_AUTO_UPDATE=!0;tn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var ut=class extends tn{constructor(){super(),this.isGroup=!0,this.type="Group"}},Hv={type:"move"},Vr=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new ut,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new ut,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new C,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new C),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new ut,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new C,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new C,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let x of e.hand.values()){let m=t.getJointPose(x,i),g=this._getHandJoint(c,x);m!==null&&(g.matrix.fromArray(m.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=m.radius),g.visible=m!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],d=u.position.distanceTo(h.position),f=.02,p=.005;c.inputState.pinching&&d>f+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&d<=f-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Hv)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new ut;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},sg={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},gs={h:0,s:0,l:0},cl={h:0,s:0,l:0};function Fh(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var Fe=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Bn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,Je.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=Je.workingColorSpace){return this.r=e,this.g=t,this.b=i,Je.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=Je.workingColorSpace){if(e=Nd(e,1),t=Ve(t,0,1),i=Ve(i,0,1),t===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=Fh(o,r,e+1/3),this.g=Fh(o,r,e),this.b=Fh(o,r,e-1/3)}return Je.colorSpaceToWorking(this,s),this}setStyle(e,t=Bn){function i(r){r!==void 0&&parseFloat(r)<1&&Ie("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Ie("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Ie("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Bn){let i=sg[e.toLowerCase()];return i!==void 0?this.setHex(i,t):Ie("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Yi(e.r),this.g=Yi(e.g),this.b=Yi(e.b),this}copyLinearToSRGB(e){return this.r=Fr(e.r),this.g=Fr(e.g),this.b=Fr(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Bn){return Je.workingToColorSpace(hn.copy(this),e),Math.round(Ve(hn.r*255,0,255))*65536+Math.round(Ve(hn.g*255,0,255))*256+Math.round(Ve(hn.b*255,0,255))}getHexString(e=Bn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=Je.workingColorSpace){Je.workingToColorSpace(hn.copy(this),t);let i=hn.r,s=hn.g,r=hn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case i:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-i)/h+2;break;case r:l=(i-s)/h+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=Je.workingColorSpace){return Je.workingToColorSpace(hn.copy(this),t),e.r=hn.r,e.g=hn.g,e.b=hn.b,e}getStyle(e=Bn){Je.workingToColorSpace(hn.copy(this),e);let t=hn.r,i=hn.g,s=hn.b;return e!==Bn?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(gs),this.setHSL(gs.h+e,gs.s+t,gs.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(gs),e.getHSL(cl);let i=ko(gs.h,cl.h,t),s=ko(gs.s,cl.s,t),r=ko(gs.l,cl.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},hn=new Fe;Fe.NAMES=sg;var $o=class extends tn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ei,this.environmentIntensity=1,this.environmentRotation=new Ei,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},ci=new C,Hi=new C,Oh=new C,Wi=new C,Sr=new C,wr=new C,Qp=new C,Bh=new C,kh=new C,zh=new C,Gh=new ot,Vh=new ot,Hh=new ot,$i=class n{constructor(e=new C,t=new C,i=new C){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),ci.subVectors(e,t),s.cross(ci);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){ci.subVectors(s,t),Hi.subVectors(i,t),Oh.subVectors(e,t);let o=ci.dot(ci),a=ci.dot(Hi),l=ci.dot(Oh),c=Hi.dot(Hi),u=Hi.dot(Oh),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let d=1/h,f=(c*l-a*u)*d,p=(o*u-a*l)*d;return r.set(1-f-p,p,f)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,Wi)===null?!1:Wi.x>=0&&Wi.y>=0&&Wi.x+Wi.y<=1}static getInterpolation(e,t,i,s,r,o,a,l){return this.getBarycoord(e,t,i,s,Wi)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Wi.x),l.addScaledVector(o,Wi.y),l.addScaledVector(a,Wi.z),l)}static getInterpolatedAttribute(e,t,i,s,r,o){return Gh.setScalar(0),Vh.setScalar(0),Hh.setScalar(0),Gh.fromBufferAttribute(e,t),Vh.fromBufferAttribute(e,i),Hh.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(Gh,r.x),o.addScaledVector(Vh,r.y),o.addScaledVector(Hh,r.z),o}static isFrontFacing(e,t,i,s){return ci.subVectors(i,t),Hi.subVectors(e,t),ci.cross(Hi).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return ci.subVectors(this.c,this.b),Hi.subVectors(this.a,this.b),ci.cross(Hi).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return n.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,s=this.b,r=this.c,o,a;Sr.subVectors(s,i),wr.subVectors(r,i),Bh.subVectors(e,i);let l=Sr.dot(Bh),c=wr.dot(Bh);if(l<=0&&c<=0)return t.copy(i);kh.subVectors(e,s);let u=Sr.dot(kh),h=wr.dot(kh);if(u>=0&&h<=u)return t.copy(s);let d=l*h-u*c;if(d<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(i).addScaledVector(Sr,o);zh.subVectors(e,r);let f=Sr.dot(zh),p=wr.dot(zh);if(p>=0&&f<=p)return t.copy(r);let x=f*c-l*p;if(x<=0&&c>=0&&p<=0)return a=c/(c-p),t.copy(i).addScaledVector(wr,a);let m=u*p-f*h;if(m<=0&&h-u>=0&&f-p>=0)return Qp.subVectors(r,s),a=(h-u)/(h-u+(f-p)),t.copy(s).addScaledVector(Qp,a);let g=1/(m+x+d);return o=x*g,a=d*g,t.copy(i).addScaledVector(Sr,o).addScaledVector(wr,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},_n=class{constructor(e=new C(1/0,1/0,1/0),t=new C(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(ui.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(ui.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=ui.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,ui):ui.fromBufferAttribute(r,o),ui.applyMatrix4(e.matrixWorld),this.expandByPoint(ui);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),ul.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),ul.copy(i.boundingBox)),ul.applyMatrix4(e.matrixWorld),this.union(ul)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,ui),ui.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Lo),hl.subVectors(this.max,Lo),Ar.subVectors(e.a,Lo),Er.subVectors(e.b,Lo),Tr.subVectors(e.c,Lo),xs.subVectors(Er,Ar),ys.subVectors(Tr,Er),Js.subVectors(Ar,Tr);let t=[0,-xs.z,xs.y,0,-ys.z,ys.y,0,-Js.z,Js.y,xs.z,0,-xs.x,ys.z,0,-ys.x,Js.z,0,-Js.x,-xs.y,xs.x,0,-ys.y,ys.x,0,-Js.y,Js.x,0];return!Wh(t,Ar,Er,Tr,hl)||(t=[1,0,0,0,1,0,0,0,1],!Wh(t,Ar,Er,Tr,hl))?!1:(dl.crossVectors(xs,ys),t=[dl.x,dl.y,dl.z],Wh(t,Ar,Er,Tr,hl))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,ui).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(ui).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(qi[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),qi[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),qi[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),qi[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),qi[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),qi[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),qi[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),qi[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(qi),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},qi=[new C,new C,new C,new C,new C,new C,new C,new C],ui=new C,ul=new _n,Ar=new C,Er=new C,Tr=new C,xs=new C,ys=new C,Js=new C,Lo=new C,hl=new C,dl=new C,Qs=new C;function Wh(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Qs.fromArray(n,r);let a=s.x*Math.abs(Qs.x)+s.y*Math.abs(Qs.y)+s.z*Math.abs(Qs.z),l=e.dot(Qs),c=t.dot(Qs),u=i.dot(Qs);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var Nt=new C,fl=new Ge,Wv=0,Rt=class extends Ai{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Wv++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=Pd,this.updateRanges=[],this.gpuType=ii,this.version=0,this._normalizationScale=e!==void 0?nu(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)fl.fromBufferAttribute(this,t),fl.applyMatrix3(e),this.setXY(t,fl.x,fl.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)Nt.fromBufferAttribute(this,t),Nt.applyMatrix3(e),this.setXYZ(t,Nt.x,Nt.y,Nt.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)Nt.fromBufferAttribute(this,t),Nt.applyMatrix4(e),this.setXYZ(t,Nt.x,Nt.y,Nt.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)Nt.fromBufferAttribute(this,t),Nt.applyNormalMatrix(e),this.setXYZ(t,Nt.x,Nt.y,Nt.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)Nt.fromBufferAttribute(this,t),Nt.transformDirection(e),this.setXYZ(t,Nt.x,Nt.y,Nt.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Ud(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Fd(e,this.array)}};var Yo=class extends Rt{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var Zo=class extends Rt{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var tt=class extends Rt{constructor(e,t,i){super(new Float32Array(e),t,i)}},qv=new _n,No=new C,qh=new C,Nn=class{constructor(e=new C,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):qv.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;No.subVectors(e,this.center);let t=No.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(No,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(qh.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(No.copy(e.center).add(qh)),this.expandByPoint(No.copy(e.center).sub(qh))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},Xv=0,Jn=new Qe,Xh=new tn,Rr=new C,On=new _n,Do=new _n,qt=new C,xt=class n extends Ai{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Xv++}),this.uuid=Cs(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(xv(e)?Zo:Yo)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new Oe().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Jn.makeRotationFromQuaternion(e),this.applyMatrix4(Jn),this}rotateX(e){return Jn.makeRotationX(e),this.applyMatrix4(Jn),this}rotateY(e){return Jn.makeRotationY(e),this.applyMatrix4(Jn),this}rotateZ(e){return Jn.makeRotationZ(e),this.applyMatrix4(Jn),this}translate(e,t,i){return Jn.makeTranslation(e,t,i),this.applyMatrix4(Jn),this}scale(e,t,i){return Jn.makeScale(e,t,i),this.applyMatrix4(Jn),this}lookAt(e){return Xh.lookAt(e),Xh.updateMatrix(),this.applyMatrix4(Xh.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Rr).negate(),this.translate(Rr.x,Rr.y,Rr.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new tt(i,3))}else{let i=Math.min(e.length,t.count);for(let s=0;s<i;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Ie("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new _n);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Ue("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new C(-1/0,-1/0,-1/0),new C(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){let r=t[i];On.setFromBufferAttribute(r),this.morphTargetsRelative?(qt.addVectors(this.boundingBox.min,On.min),this.boundingBox.expandByPoint(qt),qt.addVectors(this.boundingBox.max,On.max),this.boundingBox.expandByPoint(qt)):(this.boundingBox.expandByPoint(On.min),this.boundingBox.expandByPoint(On.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Ue('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Nn);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Ue("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new C,1/0);return}if(e){let i=this.boundingSphere.center;if(On.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];Do.setFromBufferAttribute(a),this.morphTargetsRelative?(qt.addVectors(On.min,Do.min),On.expandByPoint(qt),qt.addVectors(On.max,Do.max),On.expandByPoint(qt)):(On.expandByPoint(Do.min),On.expandByPoint(Do.max))}On.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)qt.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(qt));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)qt.fromBufferAttribute(a,c),l&&(Rr.fromBufferAttribute(e,c),qt.add(Rr)),s=Math.max(s,i.distanceToSquared(qt))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&Ue('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){Ue("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new Rt(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let I=0;I<i.count;I++)a[I]=new C,l[I]=new C;let u=new C,h=new C,d=new C,f=new Ge,p=new Ge,x=new Ge,m=new C,g=new C;function y(I,T,L){c[I]=c[T]=c[L]=1,u.fromBufferAttribute(i,I),h.fromBufferAttribute(i,T),d.fromBufferAttribute(i,L),f.fromBufferAttribute(r,I),p.fromBufferAttribute(r,T),x.fromBufferAttribute(r,L),h.sub(u),d.sub(u),p.sub(f),x.sub(f);let D=1/(p.x*x.y-x.x*p.y);isFinite(D)&&(m.copy(h).multiplyScalar(x.y).addScaledVector(d,-p.y).multiplyScalar(D),g.copy(d).multiplyScalar(p.x).addScaledVector(h,-x.x).multiplyScalar(D),a[I].add(m),a[T].add(m),a[L].add(m),l[I].add(g),l[T].add(g),l[L].add(g))}let v=this.groups;v.length===0&&(v=[{start:0,count:e.count}]);for(let I=0,T=v.length;I<T;++I){let L=v[I],D=L.start,B=L.count;for(let P=D,O=D+B;P<O;P+=3)y(e.getX(P+0),e.getX(P+1),e.getX(P+2))}let M=new C,w=new C,E=new C,_=new C;function b(I){E.fromBufferAttribute(s,I),_.copy(E);let T=a[I];M.copy(T),M.sub(E.multiplyScalar(E.dot(T))).normalize(),w.crossVectors(_,T);let D=w.dot(l[I])<0?-1:1;o.setXYZW(I,M.x,M.y,M.z,D)}for(let I=0,T=i.count;I<T;++I)c[I]&&b(I);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new Rt(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let d=0,f=i.count;d<f;d++)i.setXYZ(d,0,0,0);let s=new C,r=new C,o=new C,a=new C,l=new C,c=new C,u=new C,h=new C;if(e)for(let d=0,f=e.count;d<f;d+=3){let p=e.getX(d+0),x=e.getX(d+1),m=e.getX(d+2);s.fromBufferAttribute(t,p),r.fromBufferAttribute(t,x),o.fromBufferAttribute(t,m),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(i,p),l.fromBufferAttribute(i,x),c.fromBufferAttribute(i,m),a.add(u),l.add(u),c.add(u),i.setXYZ(p,a.x,a.y,a.z),i.setXYZ(x,l.x,l.y,l.z),i.setXYZ(m,c.x,c.y,c.z)}else for(let d=0,f=t.count;d<f;d+=3)s.fromBufferAttribute(t,d+0),r.fromBufferAttribute(t,d+1),o.fromBufferAttribute(t,d+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),i.setXYZ(d+0,u.x,u.y,u.z),i.setXYZ(d+1,u.x,u.y,u.z),i.setXYZ(d+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)qt.fromBufferAttribute(e,t),qt.normalize(),e.setXYZ(t,qt.x,qt.y,qt.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,h=a.normalized,d=new c.constructor(l.length*u),f=0,p=0;for(let x=0,m=l.length;x<m;x++){a.isInterleavedBufferAttribute?f=l[x]*a.data.stride+a.offset:f=l[x]*u;for(let g=0;g<u;g++)d[p++]=c[f++]}return new Rt(d,u,h)}if(this.index===null)return Ie("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,i);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let d=c[u],f=e(d,i);l.push(f)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,d=c.length;h<d;h++){let f=c[h];u.push(f.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],h=r[c];for(let d=0,f=h.length;d<f;d++)u.push(h[d].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},jo=class{constructor(e,t){this.isInterleavedBuffer=!0,this.array=e,this.stride=t,this.count=e!==void 0?e.length/t:0,this.usage=Pd,this.updateRanges=[],this.version=0,this.uuid=Cs()}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.array=new e.array.constructor(e.array),this.count=e.count,this.stride=e.stride,this.usage=e.usage,this}copyAt(e,t,i){e*=this.stride,i*=t.stride;for(let s=0,r=this.stride;s<r;s++)this.array[e+s]=t.array[i+s];return this}set(e,t=0){return this.array.set(e,t),this}clone(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=em(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=this.array.slice(0).buffer);let i=new this.array.constructor(e.arrayBuffers[t]),s=new this.constructor(i,this.stride);return s.setUsage(this.usage),s}onUpload(e){return this.onUploadCallback=e,this}toJSON(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=em(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let i={uuid:this.uuid,buffer:t,type:this.array.constructor.name,stride:this.stride};return i.usage=this.usage,i}};function em(n){return n.buffer._uuid===void 0&&(n.buffer._uuid=Cs()),n.byteOffset===0&&n.byteLength===n.buffer.byteLength?n.buffer._uuid:n.buffer._uuid+":"+n.byteOffset+":"+n.byteLength}var xn=new C,ei=class n{constructor(e,t,i,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=i,this.normalized=s,this._normalizationScale=e!==void 0?nu(e.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,i=this.data.count;t<i;t++)xn.fromBufferAttribute(this,t),xn.applyMatrix4(e),this.setXYZ(t,xn.x,xn.y,xn.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)xn.fromBufferAttribute(this,t),xn.applyNormalMatrix(e),this.setXYZ(t,xn.x,xn.y,xn.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)xn.fromBufferAttribute(this,t),xn.transformDirection(e),this.setXYZ(t,xn.x,xn.y,xn.z);return this}getComponent(e,t){let i=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.data.array[e*this.data.stride+this.offset+t]=i,this}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=this._denormalize(t)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=this._denormalize(t)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=this._denormalize(t)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=this._denormalize(t)),t}setXY(e,t,i){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.data.array[e+0]=t,this.data.array[e+1]=i,this}setXYZ(e,t,i,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.data.array[e+0]=t,this.data.array[e+1]=i,this.data.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.data.array[e+0]=t,this.data.array[e+1]=i,this.data.array[e+2]=s,this.data.array[e+3]=r,this}clone(e){if(e===void 0){Wo("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return new Rt(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new n(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){Wo("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Ud(e,this.data.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Fd(e,this.data.array)}},$h=new C,$v=new C,Yv=new Oe,hi=class{constructor(e=new C(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let s=$h.subVectors(i,t).cross($v.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let s=e.delta($h),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||Yv.getNormalMatrix(e),s=this.coplanarPoint($h).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},Zv=0,ti=class extends Ai{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Zv++}),this.uuid=Cs(),this.name="",this.type="Material",this.blending=jr,this.side=Ts,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=dd,this.blendDst=fd,this.blendEquation=rr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Fe(0,0,0),this.blendAlpha=0,this.depthFunc=Or,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Ym,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Ol,this.stencilZFail=Ol,this.stencilZPass=Ol,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){Ie(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ie(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new Fe().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new hi().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Ge().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Ge().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Xi=new C,Yh=new C,pl=new C,ml=new C,Hr=class{constructor(e=new C,t=new C(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Xi)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Xi.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Xi.copy(this.origin).addScaledVector(this.direction,t),Xi.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){Yh.copy(e).add(t).multiplyScalar(.5),pl.copy(t).sub(e).normalize(),ml.copy(this.origin).sub(Yh);let r=e.distanceTo(t)*.5,o=-this.direction.dot(pl),a=ml.dot(this.direction),l=-ml.dot(pl),c=ml.lengthSq(),u=Math.abs(1-o*o),h,d,f,p;if(u>0)if(h=o*l-a,d=o*a-l,p=r*u,h>=0)if(d>=-p)if(d<=p){let x=1/u;h*=x,d*=x,f=h*(h+o*d+2*a)+d*(o*h+d+2*l)+c}else d=r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d=-r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d<=-p?(h=Math.max(0,-(-o*r+a)),d=h>0?-r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c):d<=p?(h=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(h=Math.max(0,-(o*r+a)),d=h>0?r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c);else d=o>0?-r:r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(Yh).addScaledVector(pl,d),f}intersectSphere(e,t){if(e.radius<0)return null;Xi.subVectors(e.center,this.origin);let i=Xi.dot(this.direction),s=Xi.dot(Xi)-i*i,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,d=this.origin;return c>=0?(i=(e.min.x-d.x)*c,s=(e.max.x-d.x)*c):(i=(e.max.x-d.x)*c,s=(e.min.x-d.x)*c),u>=0?(r=(e.min.y-d.y)*u,o=(e.max.y-d.y)*u):(r=(e.max.y-d.y)*u,o=(e.min.y-d.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(e.min.z-d.z)*h,l=(e.max.z-d.z)*h):(a=(e.max.z-d.z)*h,l=(e.min.z-d.z)*h),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,Xi)!==null}intersectTriangle(e,t,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=e.x-o.x,d=e.y-o.y,f=e.z-o.z,p=t.x-o.x,x=t.y-o.y,m=t.z-o.z,g=i.x-o.x,y=i.y-o.y,v=i.z-o.z,M=Math.abs(l),w=Math.abs(c),E=Math.abs(u),_,b,I,T,L,D,B,P,O,H,V,ee;if(M>=w&&M>=E?(I=l,D=h,O=p,ee=g,l>=0?(_=c,b=u,T=d,L=f,B=x,P=m,H=y,V=v):(_=u,b=c,T=f,L=d,B=m,P=x,H=v,V=y)):w>=E?(I=c,D=d,O=x,ee=y,c>=0?(_=u,b=l,T=f,L=h,B=m,P=p,H=v,V=g):(_=l,b=u,T=h,L=f,B=p,P=m,H=g,V=v)):(I=u,D=f,O=m,ee=v,u>=0?(_=l,b=c,T=h,L=d,B=p,P=x,H=g,V=y):(_=c,b=l,T=d,L=h,B=x,P=p,H=y,V=g)),I===0)return null;let X=_/I,j=b/I,te=1/I,ve=T-X*D,Pe=L-j*D,Y=B-X*O,me=P-j*O,Me=H-X*ee,Le=V-j*ee,ye=Me*me-Le*Y,ze=ve*Le-Pe*Me,Pt=Y*Pe-me*ve;if(s){if(ye<0||ze<0||Pt<0)return null}else if((ye<0||ze<0||Pt<0)&&(ye>0||ze>0||Pt>0))return null;let De=ye+ze+Pt;if(De===0)return null;let lt=te*(ye*D+ze*O+Pt*ee);return(De>0?lt<0:lt>0)?null:this.at(lt/De,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},dn=class extends ti{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Fe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ei,this.combine=ga,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},tm=new Qe,er=new Hr,gl=new Nn,nm=new C,xl=new C,yl=new C,_l=new C,Zh=new C,vl=new C,im=new C,Ml=new C,Ye=class extends tn{constructor(e=new xt,t=new dn){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){vl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(Zh.fromBufferAttribute(h,e),o?vl.addScaledVector(Zh,u):vl.addScaledVector(Zh.sub(t),u))}t.add(vl)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),gl.copy(i.boundingSphere),gl.applyMatrix4(r),er.copy(e.ray).recast(e.near),!(gl.containsPoint(er.origin)===!1&&(er.intersectSphere(gl,nm)===null||er.origin.distanceToSquared(nm)>(e.far-e.near)**2))&&(tm.copy(r).invert(),er.copy(e.ray).applyMatrix4(tm),!(i.boundingBox!==null&&er.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,er)))}_computeIntersections(e,t,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,x=d.length;p<x;p++){let m=d[p],g=o[m.materialIndex],y=Math.max(m.start,f.start),v=Math.min(a.count,Math.min(m.start+m.count,f.start+f.count));for(let M=y,w=v;M<w;M+=3){let E=a.getX(M),_=a.getX(M+1),b=a.getX(M+2);s=bl(this,g,e,i,c,u,h,E,_,b),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let p=Math.max(0,f.start),x=Math.min(a.count,f.start+f.count);for(let m=p,g=x;m<g;m+=3){let y=a.getX(m),v=a.getX(m+1),M=a.getX(m+2);s=bl(this,o,e,i,c,u,h,y,v,M),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,x=d.length;p<x;p++){let m=d[p],g=o[m.materialIndex],y=Math.max(m.start,f.start),v=Math.min(l.count,Math.min(m.start+m.count,f.start+f.count));for(let M=y,w=v;M<w;M+=3){let E=M,_=M+1,b=M+2;s=bl(this,g,e,i,c,u,h,E,_,b),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let p=Math.max(0,f.start),x=Math.min(l.count,f.start+f.count);for(let m=p,g=x;m<g;m+=3){let y=m,v=m+1,M=m+2;s=bl(this,o,e,i,c,u,h,y,v,M),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}}};function jv(n,e,t,i,s,r,o,a){let l;if(e.side===Mn?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===Ts,a),l===null)return null;Ml.copy(a),Ml.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(Ml);return c<t.near||c>t.far?null:{distance:c,point:Ml.clone(),object:n}}function bl(n,e,t,i,s,r,o,a,l,c){n.getVertexPosition(a,xl),n.getVertexPosition(l,yl),n.getVertexPosition(c,_l);let u=jv(n,e,t,i,xl,yl,_l,im);if(u){let h=new C;$i.getBarycoord(im,xl,yl,_l,h),s&&(u.uv=$i.getInterpolatedAttribute(s,a,l,c,h,new Ge)),r&&(u.uv1=$i.getInterpolatedAttribute(r,a,l,c,h,new Ge)),o&&(u.normal=$i.getInterpolatedAttribute(o,a,l,c,h,new C),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new C,materialIndex:0};$i.getNormal(xl,yl,_l,d.normal),u.face=d,u.barycoord=h}return u}var di=class extends Ln{constructor(e=null,t=1,i=1,s,r,o,a,l,c=Xt,u=Xt,h,d){super(null,o,a,l,c,u,s,r,h,d),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Wr=class extends Rt{constructor(e,t,i,s=1){super(e,t,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}},Cr=new Qe,sm=new Qe,Sl=[],rm=new _n,Kv=new Qe,Uo=new Ye,Fo=new Nn,Ko=class extends Ye{constructor(e,t,i){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new Wr(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,Kv)}computeBoundingBox(){let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new _n),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,Cr),rm.copy(e.boundingBox).applyMatrix4(Cr),this.boundingBox.union(rm)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new Nn),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,Cr),Fo.copy(e.boundingSphere).applyMatrix4(Cr),this.boundingSphere.union(Fo)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=e.morphTexture!==null?e.morphTexture.clone():null,this.instanceColor=e.instanceColor!==null?e.instanceColor.clone():null,this.count=e.count,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}getColorAt(e,t){return this.instanceColor===null?t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let i=t.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,o=e*r+1;for(let a=0;a<i.length;a++)i[a]=s[o+a]}raycast(e,t){let i=this.matrixWorld,s=this.count;if(Uo.geometry=this.geometry,Uo.material=this.material,Uo.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Fo.copy(this.boundingSphere),Fo.applyMatrix4(i),e.ray.intersectsSphere(Fo)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,Cr),sm.multiplyMatrices(i,Cr),Uo.matrixWorld=sm,Uo.raycast(e,Sl);for(let o=0,a=Sl.length;o<a;o++){let l=Sl[o];l.instanceId=r,l.object=this,t.push(l)}Sl.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new Wr(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){let i=t.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new di(new Float32Array(s*this.count),s,this.count,bc,ii));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<i.length;c++)o+=i[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*e;return r[l]=a,r.set(i,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},tr=new Nn,Jv=new Ge(.5,.5),wl=new C,vs=class{constructor(e=new hi,t=new hi,i=new hi,s=new hi,r=new hi,o=new hi){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=Qn,i=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],d=r[6],f=r[7],p=r[8],x=r[9],m=r[10],g=r[11],y=r[12],v=r[13],M=r[14],w=r[15];if(s[0].setComponents(c-o,f-u,g-p,w-y).normalize(),s[1].setComponents(c+o,f+u,g+p,w+y).normalize(),s[2].setComponents(c+a,f+h,g+x,w+v).normalize(),s[3].setComponents(c-a,f-h,g-x,w-v).normalize(),i)s[4].setComponents(l,d,m,M).normalize(),s[5].setComponents(c-l,f-d,g-m,w-M).normalize();else if(s[4].setComponents(c-l,f-d,g-m,w-M).normalize(),t===Qn)s[5].setComponents(c+l,f+d,g+m,w+M).normalize();else if(t===Br)s[5].setComponents(l,d,m,M).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),tr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),tr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(tr)}intersectsSprite(e){tr.center.set(0,0,0);let t=Jv.distanceTo(e.center);return tr.radius=.7071067811865476+t,tr.applyMatrix4(e.matrixWorld),this.intersectsSphere(tr)}intersectsSphere(e){let t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let s=t[i];if(wl.x=s.normal.x>0?e.max.x:e.min.x,wl.y=s.normal.y>0?e.max.y:e.min.y,wl.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(wl)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},om=new Qe,Kl=class n{constructor(){this.coordinateSystem=Qn,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];om.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new vs),i[s].setFromProjectionMatrix(om,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new vs),t[s].copy(i[s]);return this._count=e._count,this}clone(){return new n().copy(this)}};var Ms=class extends ti{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Fe(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Jl=new C,Ql=new C,am=new Qe,Oo=new Hr,Al=new Nn,jh=new C,lm=new C,qr=class extends tn{constructor(e=new xt,t=new Ms){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)Jl.fromBufferAttribute(t,s-1),Ql.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=Jl.distanceTo(Ql);e.setAttribute("lineDistance",new tt(i,1))}else Ie("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Al.copy(i.boundingSphere),Al.applyMatrix4(s),Al.radius+=r,e.ray.intersectsSphere(Al)===!1)return;am.copy(s).invert(),Oo.copy(e.ray).applyMatrix4(am);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,d=i.attributes.position;if(u!==null){let f=Math.max(0,o.start),p=Math.min(u.count,o.start+o.count);for(let x=f,m=p-1;x<m;x+=c){let g=u.getX(x),y=u.getX(x+1),v=El(this,e,Oo,l,g,y,x);v&&t.push(v)}if(this.isLineLoop){let x=u.getX(p-1),m=u.getX(f),g=El(this,e,Oo,l,x,m,p-1);g&&t.push(g)}}else{let f=Math.max(0,o.start),p=Math.min(d.count,o.start+o.count);for(let x=f,m=p-1;x<m;x+=c){let g=El(this,e,Oo,l,x,x+1,x);g&&t.push(g)}if(this.isLineLoop){let x=El(this,e,Oo,l,p-1,f,p-1);x&&t.push(x)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function El(n,e,t,i,s,r,o){let a=n.geometry.attributes.position;if(Jl.fromBufferAttribute(a,s),Ql.fromBufferAttribute(a,r),t.distanceSqToSegment(Jl,Ql,jh,lm)>i)return;jh.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(jh);if(!(c<e.near||c>e.far))return{distance:c,point:lm.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var cm=new C,um=new C,nr=class extends qr{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[];for(let s=0,r=t.count;s<r;s+=2)cm.fromBufferAttribute(t,s),um.fromBufferAttribute(t,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+cm.distanceTo(um);e.setAttribute("lineDistance",new tt(i,1))}else Ie("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Xr=class extends ti{constructor(e){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new Fe(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.size=e.size,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},hm=new Qe,sd=new Hr,Tl=new Nn,Rl=new C,Jo=class extends tn{constructor(e=new xt,t=new Xr){super(),this.isPoints=!0,this.type="Points",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Points.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Tl.copy(i.boundingSphere),Tl.applyMatrix4(s),Tl.radius+=r,e.ray.intersectsSphere(Tl)===!1)return;hm.copy(s).invert(),sd.copy(e.ray).applyMatrix4(hm);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=i.index,h=i.attributes.position;if(c!==null){let d=Math.max(0,o.start),f=Math.min(c.count,o.start+o.count);for(let p=d,x=f;p<x;p++){let m=c.getX(p);Rl.fromBufferAttribute(h,m),dm(Rl,m,l,s,e,t,this)}}else{let d=Math.max(0,o.start),f=Math.min(h.count,o.start+o.count);for(let p=d,x=f;p<x;p++)Rl.fromBufferAttribute(h,p),dm(Rl,p,l,s,e,t,this)}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function dm(n,e,t,i,s,r,o){let a=sd.distanceSqToPoint(n);if(a<t){let l=new C;sd.closestPointToPoint(n,l),l.applyMatrix4(i);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:e,face:null,faceIndex:null,barycoord:null,object:o})}}var Qo=class extends Ln{constructor(e=[],t=or,i,s,r,o,a,l,c,u){super(e,t,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var ji=class extends Ln{constructor(e,t,i=pi,s,r,o,a=Xt,l=Xt,c,u=Zi,h=1){if(u!==Zi&&u!==Qi)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:h};super(d,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Gr(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},ea=class extends ji{constructor(e,t=pi,i=or,s,r,o=Xt,a=Xt,l,c=Zi){let u={width:e,height:e,depth:1},h=[u,u,u,u,u,u];super(e,e,t,i,s,r,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},ta=class extends Ln{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},Ki=class n extends xt{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],d=0,f=0;p("z","y","x",-1,-1,i,t,e,o,r,0),p("z","y","x",1,-1,i,t,-e,o,r,1),p("x","z","y",1,1,e,i,t,s,o,2),p("x","z","y",1,-1,e,i,-t,s,o,3),p("x","y","z",1,-1,e,t,i,s,r,4),p("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new tt(c,3)),this.setAttribute("normal",new tt(u,3)),this.setAttribute("uv",new tt(h,2));function p(x,m,g,y,v,M,w,E,_,b,I){let T=M/_,L=w/b,D=M/2,B=w/2,P=E/2,O=_+1,H=b+1,V=0,ee=0,X=new C;for(let j=0;j<H;j++){let te=j*L-B;for(let ve=0;ve<O;ve++){let Pe=ve*T-D;X[x]=Pe*y,X[m]=te*v,X[g]=P,c.push(X.x,X.y,X.z),X[x]=0,X[m]=0,X[g]=E>0?1:-1,u.push(X.x,X.y,X.z),h.push(ve/_),h.push(1-j/b),V+=1}}for(let j=0;j<b;j++)for(let te=0;te<_;te++){let ve=d+te+O*j,Pe=d+te+O*(j+1),Y=d+(te+1)+O*(j+1),me=d+(te+1)+O*j;l.push(ve,Pe,me),l.push(Pe,Y,me),ee+=6}a.addGroup(f,ee,I),f+=ee,d+=V}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var fi=class n extends xt{constructor(e=1,t=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],h=[],d=[],f=[],p=0,x=[],m=i/2,g=0;y(),o===!1&&(e>0&&v(!0),t>0&&v(!1)),this.setIndex(u),this.setAttribute("position",new tt(h,3)),this.setAttribute("normal",new tt(d,3)),this.setAttribute("uv",new tt(f,2));function y(){let M=new C,w=new C,E=0,_=(t-e)/i;for(let b=0;b<=r;b++){let I=[],T=b/r,L=T*(t-e)+e;for(let D=0;D<=s;D++){let B=D/s,P=B*l+a,O=Math.sin(P),H=Math.cos(P);w.x=L*O,w.y=-T*i+m,w.z=L*H,h.push(w.x,w.y,w.z),M.set(O,_,H).normalize(),d.push(M.x,M.y,M.z),f.push(B,1-T),I.push(p++)}x.push(I)}for(let b=0;b<s;b++)for(let I=0;I<r;I++){let T=x[I][b],L=x[I+1][b],D=x[I+1][b+1],B=x[I][b+1];(e>0||I!==0)&&(u.push(T,L,B),E+=3),(t>0||I!==r-1)&&(u.push(L,D,B),E+=3)}c.addGroup(g,E,0),g+=E}function v(M){let w=p,E=new Ge,_=new C,b=0,I=M===!0?e:t,T=M===!0?1:-1;for(let D=1;D<=s;D++)h.push(0,m*T,0),d.push(0,T,0),f.push(.5,.5),p++;let L=p;for(let D=0;D<=s;D++){let P=D/s*l+a,O=Math.cos(P),H=Math.sin(P);_.x=I*H,_.y=m*T,_.z=I*O,h.push(_.x,_.y,_.z),d.push(0,T,0),E.x=O*.5+.5,E.y=H*.5*T+.5,f.push(E.x,E.y),p++}for(let D=0;D<s;D++){let B=w+D,P=L+D;M===!0?u.push(P,P+1,B):u.push(P+1,P,B),b+=3}c.addGroup(g,b,M===!0?1:2),g+=b}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},bs=class n extends fi{constructor(e=1,t=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,e,t,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(e){return new n(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},ec=class n extends xt{constructor(e=[],t=[],i=1,s=0){super(),this.type="PolyhedronGeometry",this.parameters={vertices:e,indices:t,radius:i,detail:s};let r=[],o=[];a(s),c(i),u(),this.setAttribute("position",new tt(r,3)),this.setAttribute("normal",new tt(r.slice(),3)),this.setAttribute("uv",new tt(o,2)),s===0?this.computeVertexNormals():this.normalizeNormals();function a(y){let v=new C,M=new C,w=new C;for(let E=0;E<t.length;E+=3)f(t[E+0],v),f(t[E+1],M),f(t[E+2],w),l(v,M,w,y)}function l(y,v,M,w){let E=w+1,_=[];for(let b=0;b<=E;b++){_[b]=[];let I=y.clone().lerp(M,b/E),T=v.clone().lerp(M,b/E),L=E-b;for(let D=0;D<=L;D++)D===0&&b===E?_[b][D]=I:_[b][D]=I.clone().lerp(T,D/L)}for(let b=0;b<E;b++)for(let I=0;I<2*(E-b)-1;I++){let T=Math.floor(I/2);I%2===0?(d(_[b][T+1]),d(_[b+1][T]),d(_[b][T])):(d(_[b][T+1]),d(_[b+1][T+1]),d(_[b+1][T]))}}function c(y){let v=new C;for(let M=0;M<r.length;M+=3)v.x=r[M+0],v.y=r[M+1],v.z=r[M+2],v.normalize().multiplyScalar(y),r[M+0]=v.x,r[M+1]=v.y,r[M+2]=v.z}function u(){let y=new C;for(let v=0;v<r.length;v+=3){y.x=r[v+0],y.y=r[v+1],y.z=r[v+2];let M=m(y)/2/Math.PI+.5,w=g(y)/Math.PI+.5;o.push(M,1-w)}p(),h()}function h(){for(let y=0;y<o.length;y+=6){let v=o[y+0],M=o[y+2],w=o[y+4],E=Math.max(v,M,w),_=Math.min(v,M,w);E>.9&&_<.1&&(v<.2&&(o[y+0]+=1),M<.2&&(o[y+2]+=1),w<.2&&(o[y+4]+=1))}}function d(y){r.push(y.x,y.y,y.z)}function f(y,v){let M=y*3;v.x=e[M+0],v.y=e[M+1],v.z=e[M+2]}function p(){let y=new C,v=new C,M=new C,w=new C,E=new Ge,_=new Ge,b=new Ge;for(let I=0,T=0;I<r.length;I+=9,T+=6){y.set(r[I+0],r[I+1],r[I+2]),v.set(r[I+3],r[I+4],r[I+5]),M.set(r[I+6],r[I+7],r[I+8]),E.set(o[T+0],o[T+1]),_.set(o[T+2],o[T+3]),b.set(o[T+4],o[T+5]),w.copy(y).add(v).add(M).divideScalar(3);let L=m(w);x(E,T+0,y,L),x(_,T+2,v,L),x(b,T+4,M,L)}}function x(y,v,M,w){w<0&&y.x===1&&(o[v]=y.x-1),M.x===0&&M.z===0&&(o[v]=w/2/Math.PI+.5)}function m(y){return Math.atan2(y.z,-y.x)}function g(y){return Math.atan2(-y.y,Math.sqrt(y.x*y.x+y.z*y.z))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.vertices,e.indices,e.radius,e.detail)}};var Cl=new C,Il=new C,Kh=new C,Pl=new $i,$r=class extends xt{constructor(e=null,t=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:e,thresholdAngle:t},e!==null){let s=Math.pow(10,4),r=Math.cos(Ur*t),o=e.getIndex(),a=e.getAttribute("position"),l=o?o.count:a.count,c=[0,0,0],u=["a","b","c"],h=new Array(3),d=new Map,f=[];for(let p=0;p<l;p+=3){o?(c[0]=o.getX(p),c[1]=o.getX(p+1),c[2]=o.getX(p+2)):(c[0]=p,c[1]=p+1,c[2]=p+2);let{a:x,b:m,c:g}=Pl;if(x.fromBufferAttribute(a,c[0]),m.fromBufferAttribute(a,c[1]),g.fromBufferAttribute(a,c[2]),Pl.getNormal(Kh),h[0]=`${Math.round(x.x*s)},${Math.round(x.y*s)},${Math.round(x.z*s)}`,h[1]=`${Math.round(m.x*s)},${Math.round(m.y*s)},${Math.round(m.z*s)}`,h[2]=`${Math.round(g.x*s)},${Math.round(g.y*s)},${Math.round(g.z*s)}`,!(h[0]===h[1]||h[1]===h[2]||h[2]===h[0]))for(let y=0;y<3;y++){let v=(y+1)%3,M=h[y],w=h[v],E=Pl[u[y]],_=Pl[u[v]],b=`${M}_${w}`,I=`${w}_${M}`,T=d.get(I);T?(Kh.dot(T.normal)<=r&&(f.push(E.x,E.y,E.z),f.push(_.x,_.y,_.z)),d.set(I,null)):d.has(b)||d.set(b,{index0:c[y],index1:c[v],normal:Kh.clone()})}}for(let p of d.values())if(p){let{index0:x,index1:m}=p;Cl.fromBufferAttribute(a,x),Il.fromBufferAttribute(a,m),f.push(Cl.x,Cl.y,Cl.z),f.push(Il.x,Il.y,Il.z)}this.setAttribute("position",new tt(f,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}};var na=class n extends ec{constructor(e=1,t=0){let i=[1,0,0,-1,0,0,0,1,0,0,-1,0,0,0,1,0,0,-1],s=[0,2,4,0,4,3,0,3,5,0,5,2,1,2,5,1,5,3,1,3,4,1,4,2];super(i,s,e,t),this.type="OctahedronGeometry",this.parameters={radius:e,detail:t}}static fromJSON(e){return new n(e.radius,e.detail)}},ir=class n extends xt{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,h=e/a,d=t/l,f=[],p=[],x=[],m=[];for(let g=0;g<u;g++){let y=g*d-o;for(let v=0;v<c;v++){let M=v*h-r;p.push(M,-y,0),x.push(0,0,1),m.push(v/a),m.push(1-g/l)}}for(let g=0;g<l;g++)for(let y=0;y<a;y++){let v=y+c*g,M=y+c*(g+1),w=y+1+c*(g+1),E=y+1+c*g;f.push(v,M,E),f.push(M,w,E)}this.setIndex(f),this.setAttribute("position",new tt(p,3)),this.setAttribute("normal",new tt(x,3)),this.setAttribute("uv",new tt(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};var zn=class n extends xt{constructor(e=1,t=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new C,d=new C,f=[],p=[],x=[],m=[];for(let g=0;g<=i;g++){let y=[],v=g/i,M=o+v*a,w=e*Math.cos(M),E=Math.sqrt(e*e-w*w),_=0;g===0&&o===0?_=.5/t:g===i&&l===Math.PI&&(_=-.5/t);for(let b=0;b<=t;b++){let I=b/t,T=s+I*r;h.x=-E*Math.cos(T),h.y=w,h.z=E*Math.sin(T),p.push(h.x,h.y,h.z),d.copy(h).normalize(),x.push(d.x,d.y,d.z),m.push(I+_,1-v),y.push(c++)}u.push(y)}for(let g=0;g<i;g++)for(let y=0;y<t;y++){let v=u[g][y+1],M=u[g][y],w=u[g+1][y],E=u[g+1][y+1];(g!==0||o>0)&&f.push(v,M,E),(g!==i-1||l<Math.PI)&&f.push(M,w,E)}this.setIndex(f),this.setAttribute("position",new tt(p,3)),this.setAttribute("normal",new tt(x,3)),this.setAttribute("uv",new tt(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};var ia=class n extends xt{constructor(e=1,t=.4,i=12,s=48,r=Math.PI*2,o=0,a=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:e,tube:t,radialSegments:i,tubularSegments:s,arc:r,thetaStart:o,thetaLength:a},i=Math.floor(i),s=Math.floor(s);let l=[],c=[],u=[],h=[],d=new C,f=new C,p=new C;for(let x=0;x<=i;x++){let m=o+x/i*a;for(let g=0;g<=s;g++){let y=g/s*r;f.x=(e+t*Math.cos(m))*Math.cos(y),f.y=(e+t*Math.cos(m))*Math.sin(y),f.z=t*Math.sin(m),c.push(f.x,f.y,f.z),d.x=e*Math.cos(y),d.y=e*Math.sin(y),p.subVectors(f,d).normalize(),u.push(p.x,p.y,p.z),h.push(g/s),h.push(x/i)}}for(let x=1;x<=i;x++)for(let m=1;m<=s;m++){let g=(s+1)*x+m-1,y=(s+1)*(x-1)+m-1,v=(s+1)*(x-1)+m,M=(s+1)*x+m;l.push(g,y,M),l.push(y,v,M)}this.setIndex(l),this.setAttribute("position",new tt(c,3)),this.setAttribute("normal",new tt(u,3)),this.setAttribute("uv",new tt(h,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.tube,e.radialSegments,e.tubularSegments,e.arc,e.thetaStart,e.thetaLength)}};var sa=class extends xt{constructor(e=null){if(super(),this.type="WireframeGeometry",this.parameters={geometry:e},e!==null){let t=[],i=new Set,s=new C,r=new C;if(e.index!==null){let o=e.attributes.position,a=e.index,l=e.groups;l.length===0&&(l=[{start:0,count:a.count,materialIndex:0}]);for(let c=0,u=l.length;c<u;++c){let h=l[c],d=h.start,f=h.count;for(let p=d,x=d+f;p<x;p+=3)for(let m=0;m<3;m++){let g=a.getX(p+m),y=a.getX(p+(m+1)%3);s.fromBufferAttribute(o,g),r.fromBufferAttribute(o,y),fm(s,r,i)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}}else{let o=e.attributes.position;for(let a=0,l=o.count/3;a<l;a++)for(let c=0;c<3;c++){let u=3*a+c,h=3*a+(c+1)%3;s.fromBufferAttribute(o,u),r.fromBufferAttribute(o,h),fm(s,r,i)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}this.setAttribute("position",new tt(t,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}};function fm(n,e,t){let i=`${n.x},${n.y},${n.z}-${e.x},${e.y},${e.z}`,s=`${e.x},${e.y},${e.z}-${n.x},${n.y},${n.z}`;return t.has(i)===!0||t.has(s)===!0?!1:(t.add(i),t.add(s),!0)}function lr(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let s=n[t][i];if(pm(s))s.isRenderTargetTexture?(Ie("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(pm(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function fn(n){let e={};for(let t=0;t<n.length;t++){let i=lr(n[t]);for(let s in i)e[s]=i[s]}return e}function pm(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function Qv(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function Od(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:Je.workingColorSpace}var wa={clone:lr,merge:fn},eM=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,tM=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,ni=class extends ti{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=eM,this.fragmentShader=tM,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=lr(e.uniforms),this.uniformsGroups=Qv(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new Fe().setHex(s.value);break;case"v2":this.uniforms[i].value=new Ge().fromArray(s.value);break;case"v3":this.uniforms[i].value=new C().fromArray(s.value);break;case"v4":this.uniforms[i].value=new ot().fromArray(s.value);break;case"m3":this.uniforms[i].value=new Oe().fromArray(s.value);break;case"m4":this.uniforms[i].value=new Qe().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},tc=class extends ni{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var ra=class extends ti{constructor(e){super(),this.isMeshPhongMaterial=!0,this.type="MeshPhongMaterial",this.color=new Fe(16777215),this.specular=new Fe(1118481),this.shininess=30,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Fe(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Qr,this.normalScale=new Ge(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ei,this.combine=ga,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.specular.copy(e.specular),this.shininess=e.shininess,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}};var vn=class extends ti{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Fe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Fe(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Qr,this.normalScale=new Ge(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ei,this.combine=ga,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},nc=class extends ti{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Xm,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},ic=class extends ti{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}},oa=class extends ti{constructor(e){super(),this.isMeshMatcapMaterial=!0,this.defines={MATCAP:""},this.type="MeshMatcapMaterial",this.color=new Fe(16777215),this.matcap=null,this.map=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Qr,this.normalScale=new Ge(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.alphaMap=null,this.wireframe=!1,this.wireframeLinewidth=1,this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.defines={MATCAP:""},this.color.copy(e.color),this.matcap=e.matcap,this.map=e.map,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.alphaMap=e.alphaMap,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.flatShading=e.flatShading,this.fog=e.fog,this}};function Ir(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function Ll(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var Ss=class{constructor(e,t,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,s=t[i],r=t[i-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=i+2;;){if(s===void 0){if(e<r)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=t[++i],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=t[--i-1],e>=r)break e}o=i,i=0;break t}break n}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(s=t[i],r=t[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=i[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},sc=class extends Ss{constructor(e,t,i,s){super(e,t,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:td,endingEnd:td}}intervalChanged_(e,t,i){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case nd:r=e,a=2*t-i;break;case id:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case nd:o=e,l=2*i-t;break;case id:o=1,l=i+s[1]-s[0];break;default:o=e-1,l=t}let c=(i-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,d=this._weightPrev,f=this._weightNext,p=(i-t)/(s-t),x=p*p,m=x*p,g=-d*m+2*d*x-d*p,y=(1+d)*m+(-1.5-2*d)*x+(-.5+d)*p+1,v=(-1-f)*m+(1.5+f)*x+.5*p,M=f*m-f*x;for(let w=0;w!==a;++w)r[w]=g*o[u+w]+y*o[c+w]+v*o[l+w]+M*o[h+w];return r}},rc=class extends Ss{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(i-t)/(s-t),h=1-u;for(let d=0;d!==a;++d)r[d]=o[c+d]*h+o[l+d]*u;return r}},oc=class extends Ss{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},ac=class extends Ss{interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let p=(i-t)/(s-t),x=1-p;for(let m=0;m!==a;++m)r[m]=o[c+m]*x+o[l+m]*p;return r}let d=a*2,f=e-1;for(let p=0;p!==a;++p){let x=o[c+p],m=o[l+p],g=f*d+p*2,y=h[g],v=h[g+1],M=e*d+p*2,w=u[M],E=u[M+1],_=iM(i,t,y,w,s);r[p]=rg(_,x,v,E,m)}return r}};function rg(n,e,t,i,s){let r=1-n;return r*r*r*e+3*r*r*n*t+3*r*n*n*i+n*n*n*s}function nM(n,e,t,i,s){let r=1-n;return 3*r*r*(t-e)+6*r*n*(i-t)+3*n*n*(s-i)}function iM(n,e,t,i,s){let r=(n-e)/(s-e);for(let o=0;o<8;o++){let a=rg(r,e,t,i,s)-n;if(Math.abs(a)<1e-10)break;let l=nM(r,e,t,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var Gn=class{constructor(e,t,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Ir(t,this.TimeBufferType),this.values=Ir(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:Ir(e.times,Array),values:Ir(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s),Ll(e.settings)&&(i.settings={inTangents:Ir(e.settings.inTangents,Array),outTangents:Ir(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new oc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new rc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new sc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new ac(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case zo:t=this.InterpolantFactoryMethodDiscrete;break;case $l:t=this.InterpolantFactoryMethodLinear;break;case Fl:t=this.InterpolantFactoryMethodSmooth;break;case ed:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Ie("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return zo;case this.InterpolantFactoryMethodLinear:return $l;case this.InterpolantFactoryMethodSmooth:return Fl;case this.InterpolantFactoryMethodBezier:return ed}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]+=e;Ll(this.settings)&&(mm(this.settings.inTangents,e),mm(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]*=e;Ll(this.settings)&&(gm(this.settings.inTangents,e),gm(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<e;)++r;for(;o!==-1&&i[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(Ue("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(Ue("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){Ue("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){Ue("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&yv(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){Ue("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===Fl,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let h=a*i,d=h-i,f=h+i;for(let p=0;p!==i;++p){let x=t[h+p];if(x!==t[d+p]||x!==t[f+p]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let h=a*i,d=o*i;for(let f=0;f!==i;++f)t[d+f]=t[h+f]}++o}}if(r>0){e[o]=e[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,s=new i(this.name,e,t);return s.createInterpolant=this.createInterpolant,Ll(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function mm(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function gm(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}Gn.prototype.ValueTypeName="";Gn.prototype.TimeBufferType=Float32Array;Gn.prototype.ValueBufferType=Float32Array;Gn.prototype.DefaultInterpolation=$l;var ws=class extends Gn{constructor(e,t,i){super(e,t,i)}};ws.prototype.ValueTypeName="bool";ws.prototype.ValueBufferType=Array;ws.prototype.DefaultInterpolation=zo;ws.prototype.InterpolantFactoryMethodLinear=void 0;ws.prototype.InterpolantFactoryMethodSmooth=void 0;var lc=class extends Gn{constructor(e,t,i,s){super(e,t,i,s)}};lc.prototype.ValueTypeName="color";var cc=class extends Gn{constructor(e,t,i,s){super(e,t,i,s)}};cc.prototype.ValueTypeName="number";var uc=class extends Ss{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)rt.slerpFlat(r,0,o,c-a,o,c,l);return r}},aa=class extends Gn{constructor(e,t,i,s){super(e,t,i,s)}InterpolantFactoryMethodLinear(e){return new uc(this.times,this.values,this.getValueSize(),e)}};aa.prototype.ValueTypeName="quaternion";aa.prototype.InterpolantFactoryMethodSmooth=void 0;var As=class extends Gn{constructor(e,t,i){super(e,t,i)}};As.prototype.ValueTypeName="string";As.prototype.ValueBufferType=Array;As.prototype.DefaultInterpolation=zo;As.prototype.InterpolantFactoryMethodLinear=void 0;As.prototype.InterpolantFactoryMethodSmooth=void 0;var hc=class extends Gn{constructor(e,t,i,s){super(e,t,i,s)}};hc.prototype.ValueTypeName="vector";var dc=class{constructor(e,t,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,d=c.length;h<d;h+=2){let f=c[h],p=c[h+1];if(f.global&&(f.lastIndex=0),f.test(u))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},og=new dc,fc=class{constructor(e){this.manager=e!==void 0?e:og,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(s,r){i.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};fc.DEFAULT_MATERIAL_NAME="__DEFAULT";var la=class extends tn{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new Fe(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}};var Jh=new Qe,xm=new C,ym=new C,pc=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Ge(512,512),this.mapType=Dn,this.map=null,this.mapPass=null,this.matrix=new Qe,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new vs,this._frameExtents=new Ge(1,1),this._viewportCount=1,this._viewports=[new ot(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;xm.setFromMatrixPosition(e.matrixWorld),t.position.copy(xm),ym.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(ym),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,i,s){Jh.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),i.setFromProjectionMatrix(Jh,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===Br||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(Jh)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},Nl=new C,Dl=new rt,Si=new C,ca=class extends tn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Qe,this.projectionMatrix=new Qe,this.projectionMatrixInverse=new Qe,this.coordinateSystem=Qn,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Nl,Dl,Si),Si.x===1&&Si.y===1&&Si.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Nl,Dl,Si.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(Nl,Dl,Si),Si.x===1&&Si.y===1&&Si.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Nl,Dl,Si.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},_s=new C,_m=new Ge,vm=new Ge,yn=class extends ca{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=zr*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Ur*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return zr*2*Math.atan(Math.tan(Ur*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){_s.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(_s.x,_s.y).multiplyScalar(-e/_s.z),_s.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(_s.x,_s.y).multiplyScalar(-e/_s.z)}getViewSize(e,t){return this.getViewBounds(e,_m,vm),t.subVectors(vm,_m)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Ur*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var ua=class extends ca{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,o=i+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},rd=class extends pc{constructor(){super(new ua(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},ha=class extends la{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(tn.DEFAULT_UP),this.updateMatrix(),this.target=new tn,this.shadow=new rd}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}},da=class extends la{constructor(e,t){super(e,t),this.isAmbientLight=!0,this.type="AmbientLight"}};var fa=class extends xt{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var Pr=-90,Lr=1,Yr=class extends tn{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new yn(Pr,Lr,e,t);s.layers=this.layers,this.add(s);let r=new yn(Pr,Lr,e,t);r.layers=this.layers,this.add(r);let o=new yn(Pr,Lr,e,t);o.layers=this.layers,this.add(o);let a=new yn(Pr,Lr,e,t);a.layers=this.layers,this.add(a);let l=new yn(Pr,Lr,e,t);l.layers=this.layers,this.add(l);let c=new yn(Pr,Lr,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Qn)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Br)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=e.getRenderTarget(),d=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),p=e.xr.enabled;e.xr.enabled=!1;let x=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let m=!1;e.isWebGLRenderer===!0?m=e.state.buffers.depth.getReversed():m=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=x,e.setRenderTarget(i,5,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(h,d,f),e.xr.enabled=p,i.texture.needsPMREMUpdate=!0}},mc=class extends yn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var Bd="\\[\\]\\.:\\/",sM=new RegExp("["+Bd+"]","g"),kd="[^"+Bd+"]",rM="[^"+Bd.replace("\\.","")+"]",oM=/((?:WC+[\/:])*)/.source.replace("WC",kd),aM=/(WCOD+)?/.source.replace("WCOD",rM),lM=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",kd),cM=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",kd),uM=new RegExp("^"+oM+aM+lM+cM+"$"),hM=["material","materials","bones","map"],od=class{constructor(e,t,i){let s=i||vt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},vt=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(sM,"")}static parseTrackName(e){let t=uM.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);hM.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[t++]=i[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Ie("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){Ue("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){Ue("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){Ue("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){Ue("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){Ue("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){Ue("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){Ue("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;Ue("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){Ue("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){Ue("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};vt.Composite=od;vt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};vt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};vt.prototype.GetterByBindingType=[vt.prototype._getValue_direct,vt.prototype._getValue_array,vt.prototype._getValue_arrayElement,vt.prototype._getValue_toArray];vt.prototype.SetterByBindingTypeAndVersioning=[[vt.prototype._setValue_direct,vt.prototype._setValue_direct_setNeedsUpdate,vt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[vt.prototype._setValue_array,vt.prototype._setValue_array_setNeedsUpdate,vt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[vt.prototype._setValue_arrayElement,vt.prototype._setValue_arrayElement_setNeedsUpdate,vt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[vt.prototype._setValue_fromArray,vt.prototype._setValue_fromArray_setNeedsUpdate,vt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var $L=new Float32Array(1);var Es=class extends jo{constructor(e,t,i=1){super(e,t),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=i}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}clone(e){let t=super.clone(e);return t.meshPerAttribute=this.meshPerAttribute,t}toJSON(e){let t=super.toJSON(e);return t.isInstancedInterleavedBuffer=!0,t.meshPerAttribute=this.meshPerAttribute,t}};var ad=class{static{this.prototype.isMatrix2=!0}constructor(e,t,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=i,r[3]=s,this}};var Mm=new C,Ul=new C,Nr=new C,Dr=new C,Qh=new C,dM=new C,fM=new C,pa=class{constructor(e=new C,t=new C){this.start=e,this.end=t}set(e,t){return this.start.copy(e),this.end.copy(t),this}copy(e){return this.start.copy(e.start),this.end.copy(e.end),this}getCenter(e){return e.addVectors(this.start,this.end).multiplyScalar(.5)}delta(e){return e.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(e,t){return this.delta(t).multiplyScalar(e).add(this.start)}closestPointToPointParameter(e,t){Mm.subVectors(e,this.start),Ul.subVectors(this.end,this.start);let i=Ul.dot(Ul);if(i===0)return 0;let r=Ul.dot(Mm)/i;return t&&(r=Ve(r,0,1)),r}closestPointToPoint(e,t,i){let s=this.closestPointToPointParameter(e,t);return this.delta(i).multiplyScalar(s).add(this.start)}distanceSqToLine3(e,t=dM,i=fM){let s=10000000000000001e-32,r,o,a=this.start,l=e.start,c=this.end,u=e.end;Nr.subVectors(c,a),Dr.subVectors(u,l),Qh.subVectors(a,l);let h=Nr.dot(Nr),d=Dr.dot(Dr),f=Dr.dot(Qh);if(h<=s&&d<=s)return t.copy(a),i.copy(l),t.distanceToSquared(i);if(h<=s)r=0,o=f/d,o=Ve(o,0,1);else{let p=Nr.dot(Qh);if(d<=s)o=0,r=Ve(-p/h,0,1);else{let x=Nr.dot(Dr),m=h*d-x*x;m!==0?r=Ve((x*f-p*d)/m,0,1):r=0,o=(x*r+f)/d,o<0?(o=0,r=Ve(-p/h,0,1)):o>1&&(o=1,r=Ve((x-p)/h,0,1))}}return t.copy(a).addScaledVector(Nr,r),i.copy(l).addScaledVector(Dr,o),t.distanceToSquared(i)}applyMatrix4(e){return this.start.applyMatrix4(e),this.end.applyMatrix4(e),this}equals(e){return e.start.equals(this.start)&&e.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};function zd(n,e,t,i){let s=pM(i);switch(t){case Ed:return n*e;case bc:return n*e/s.components*s.byteLength;case Sc:return n*e/s.components*s.byteLength;case Rs:return n*e*2/s.components*s.byteLength;case wc:return n*e*2/s.components*s.byteLength;case Td:return n*e*3/s.components*s.byteLength;case gi:return n*e*4/s.components*s.byteLength;case Ac:return n*e*4/s.components*s.byteLength;case ya:case _a:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case va:case Ma:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Tc:case Cc:return Math.max(n,16)*Math.max(e,8)/4;case Ec:case Rc:return Math.max(n,8)*Math.max(e,8)/2;case Ic:case Pc:case Nc:case Dc:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Lc:case ba:case Uc:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Fc:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Oc:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case Bc:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case kc:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case zc:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case Gc:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case Vc:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case Hc:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case Wc:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case qc:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case Xc:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case $c:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case Yc:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case Zc:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case jc:case Kc:case Jc:return Math.ceil(n/4)*Math.ceil(e/4)*16;case Qc:case eu:return Math.ceil(n/4)*Math.ceil(e/4)*8;case Sa:case tu:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function pM(n){switch(n){case Dn:case bd:return{byteLength:1,components:1};case Jr:case Sd:case mi:return{byteLength:2,components:1};case vc:case Mc:return{byteLength:2,components:4};case pi:case _c:case ii:return{byteLength:4,components:1};case wd:case Ad:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ie("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Rg(){let n=null,e=!1,t=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function _M(n){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,h=c.byteLength,d=n.createBuffer();n.bindBuffer(l,d),n.bufferData(l,c,u),a.onUploadCallback();let f;if(c instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=n.SHORT;else if(c instanceof Uint32Array)f=n.UNSIGNED_INT;else if(c instanceof Int32Array)f=n.INT;else if(c instanceof Int8Array)f=n.BYTE;else if(c instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,l,c){let u=l.array,h=l.updateRanges;if(n.bindBuffer(c,a),h.length===0)n.bufferSubData(c,0,u);else{h.sort((f,p)=>f.start-p.start);let d=0;for(let f=1;f<h.length;f++){let p=h[d],x=h[f];x.start<=p.start+p.count+1?p.count=Math.max(p.count,x.start+x.count-p.start):(++d,h[d]=x)}h.length=d+1;for(let f=0,p=h.length;f<p;f++){let x=h[f];n.bufferSubData(c,x.start*u.BYTES_PER_ELEMENT,u,x.start,x.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var vM=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,MM=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,bM=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,SM=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,wM=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,AM=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,EM=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,TM=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,RM=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,CM=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,IM=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,PM=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,LM=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,NM=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,DM=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,UM=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,FM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,OM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,BM=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,kM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,zM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,GM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,VM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,HM=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,WM=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,qM=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,XM=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,$M=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,YM=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,ZM="gl_FragColor = linearToOutputTexel( gl_FragColor );",jM=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,KM=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,JM=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,QM=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,eb=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,tb=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,nb=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,ib=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,sb=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,rb=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,ob=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,ab=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,lb=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,cb=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,ub=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,hb=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,db=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,fb=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,pb=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,mb=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,gb=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,xb=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,yb=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,_b=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,vb=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Mb=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,bb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Sb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,wb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Ab=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Eb=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Tb=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Rb=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,Cb=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Ib=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Pb=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Lb=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Nb=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,Db=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Ub=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,Fb=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Ob=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,Bb=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,kb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,zb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Gb=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,Vb=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,Hb=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Wb=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,qb=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,Xb=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,$b=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Yb=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,Zb=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,jb=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Kb=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Jb=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,Qb=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,eS=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,tS=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,nS=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,iS=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,sS=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,rS=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,oS=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,aS=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,lS=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,cS=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,uS=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,hS=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,dS=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,fS=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,pS=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,mS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,gS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,xS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,yS=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,_S=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,vS=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,MS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,bS=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,SS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,wS=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,AS=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,ES=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,TS=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,RS=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,CS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,IS=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,PS=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,LS=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,NS=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,DS=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,US=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,FS=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,OS=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,BS=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,kS=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,zS=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,GS=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,VS=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,HS=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,WS=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,qS=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,XS=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,$S=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,YS=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,ZS=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,jS=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,KS=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,JS=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,$e={alphahash_fragment:vM,alphahash_pars_fragment:MM,alphamap_fragment:bM,alphamap_pars_fragment:SM,alphatest_fragment:wM,alphatest_pars_fragment:AM,aomap_fragment:EM,aomap_pars_fragment:TM,batching_pars_vertex:RM,batching_vertex:CM,begin_vertex:IM,beginnormal_vertex:PM,bsdfs:LM,iridescence_fragment:NM,bumpmap_pars_fragment:DM,clipping_planes_fragment:UM,clipping_planes_pars_fragment:FM,clipping_planes_pars_vertex:OM,clipping_planes_vertex:BM,color_fragment:kM,color_pars_fragment:zM,color_pars_vertex:GM,color_vertex:VM,common:HM,defaultnormal_vertex:WM,displacementmap_pars_vertex:qM,displacementmap_vertex:XM,emissivemap_fragment:$M,emissivemap_pars_fragment:YM,colorspace_fragment:ZM,colorspace_pars_fragment:jM,envmap_fragment:KM,envmap_common_pars_fragment:JM,envmap_pars_fragment:QM,envmap_pars_vertex:eb,envmap_physical_pars_fragment:hb,envmap_vertex:tb,fog_vertex:nb,fog_pars_vertex:ib,fog_fragment:sb,fog_pars_fragment:rb,gradientmap_pars_fragment:ob,lightmap_pars_fragment:ab,lights_lambert_fragment:lb,lights_lambert_pars_fragment:cb,lights_pars_begin:ub,lights_toon_fragment:db,lights_toon_pars_fragment:fb,lights_phong_fragment:pb,lights_phong_pars_fragment:mb,lights_physical_fragment:gb,lights_physical_pars_fragment:xb,lights_fragment_begin:yb,lights_fragment_maps:_b,lights_fragment_end:vb,lightprobes_pars_fragment:Mb,logdepthbuf_fragment:bb,logdepthbuf_pars_fragment:Sb,logdepthbuf_pars_vertex:wb,logdepthbuf_vertex:Ab,map_fragment:Eb,map_pars_fragment:Tb,map_particle_fragment:Rb,map_particle_pars_fragment:Cb,metalnessmap_fragment:Ib,metalnessmap_pars_fragment:Pb,morphinstance_vertex:Lb,morphcolor_vertex:Nb,morphnormal_vertex:Db,morphtarget_pars_vertex:Ub,morphtarget_vertex:Fb,normal_fragment_begin:Ob,normal_fragment_maps:Bb,normal_pars_fragment:kb,normal_pars_vertex:zb,normal_vertex:Gb,normalmap_pars_fragment:Vb,clearcoat_normal_fragment_begin:Hb,clearcoat_normal_fragment_maps:Wb,clearcoat_pars_fragment:qb,iridescence_pars_fragment:Xb,opaque_fragment:$b,packing:Yb,premultiplied_alpha_fragment:Zb,project_vertex:jb,dithering_fragment:Kb,dithering_pars_fragment:Jb,roughnessmap_fragment:Qb,roughnessmap_pars_fragment:eS,shadowmap_pars_fragment:tS,shadowmap_pars_vertex:nS,shadowmap_vertex:iS,shadowmask_pars_fragment:sS,skinbase_vertex:rS,skinning_pars_vertex:oS,skinning_vertex:aS,skinnormal_vertex:lS,specularmap_fragment:cS,specularmap_pars_fragment:uS,tonemapping_fragment:hS,tonemapping_pars_fragment:dS,transmission_fragment:fS,transmission_pars_fragment:pS,uv_pars_fragment:mS,uv_pars_vertex:gS,uv_vertex:xS,worldpos_vertex:yS,background_vert:_S,background_frag:vS,backgroundCube_vert:MS,backgroundCube_frag:bS,cube_vert:SS,cube_frag:wS,depth_vert:AS,depth_frag:ES,distance_vert:TS,distance_frag:RS,equirect_vert:CS,equirect_frag:IS,linedashed_vert:PS,linedashed_frag:LS,meshbasic_vert:NS,meshbasic_frag:DS,meshlambert_vert:US,meshlambert_frag:FS,meshmatcap_vert:OS,meshmatcap_frag:BS,meshnormal_vert:kS,meshnormal_frag:zS,meshphong_vert:GS,meshphong_frag:VS,meshphysical_vert:HS,meshphysical_frag:WS,meshtoon_vert:qS,meshtoon_frag:XS,points_vert:$S,points_frag:YS,shadow_vert:ZS,shadow_frag:jS,sprite_vert:KS,sprite_frag:JS},fe={common:{diffuse:{value:new Fe(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Oe},alphaMap:{value:null},alphaMapTransform:{value:new Oe},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Oe}},envmap:{envMap:{value:null},envMapRotation:{value:new Oe},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Oe}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Oe}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Oe},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Oe},normalScale:{value:new Ge(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Oe},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Oe}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Oe}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Oe}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Fe(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Fe(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Oe},alphaTest:{value:0},uvTransform:{value:new Oe}},sprite:{diffuse:{value:new Fe(16777215)},opacity:{value:1},center:{value:new Ge(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Oe},alphaMap:{value:null},alphaMapTransform:{value:new Oe},alphaTest:{value:0}}},bn={basic:{uniforms:fn([fe.common,fe.specularmap,fe.envmap,fe.aomap,fe.lightmap,fe.fog]),vertexShader:$e.meshbasic_vert,fragmentShader:$e.meshbasic_frag},lambert:{uniforms:fn([fe.common,fe.specularmap,fe.envmap,fe.aomap,fe.lightmap,fe.emissivemap,fe.bumpmap,fe.normalmap,fe.displacementmap,fe.fog,fe.lights,{emissive:{value:new Fe(0)},envMapIntensity:{value:1}}]),vertexShader:$e.meshlambert_vert,fragmentShader:$e.meshlambert_frag},phong:{uniforms:fn([fe.common,fe.specularmap,fe.envmap,fe.aomap,fe.lightmap,fe.emissivemap,fe.bumpmap,fe.normalmap,fe.displacementmap,fe.fog,fe.lights,{emissive:{value:new Fe(0)},specular:{value:new Fe(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:$e.meshphong_vert,fragmentShader:$e.meshphong_frag},standard:{uniforms:fn([fe.common,fe.envmap,fe.aomap,fe.lightmap,fe.emissivemap,fe.bumpmap,fe.normalmap,fe.displacementmap,fe.roughnessmap,fe.metalnessmap,fe.fog,fe.lights,{emissive:{value:new Fe(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:$e.meshphysical_vert,fragmentShader:$e.meshphysical_frag},toon:{uniforms:fn([fe.common,fe.aomap,fe.lightmap,fe.emissivemap,fe.bumpmap,fe.normalmap,fe.displacementmap,fe.gradientmap,fe.fog,fe.lights,{emissive:{value:new Fe(0)}}]),vertexShader:$e.meshtoon_vert,fragmentShader:$e.meshtoon_frag},matcap:{uniforms:fn([fe.common,fe.bumpmap,fe.normalmap,fe.displacementmap,fe.fog,{matcap:{value:null}}]),vertexShader:$e.meshmatcap_vert,fragmentShader:$e.meshmatcap_frag},points:{uniforms:fn([fe.points,fe.fog]),vertexShader:$e.points_vert,fragmentShader:$e.points_frag},dashed:{uniforms:fn([fe.common,fe.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:$e.linedashed_vert,fragmentShader:$e.linedashed_frag},depth:{uniforms:fn([fe.common,fe.displacementmap]),vertexShader:$e.depth_vert,fragmentShader:$e.depth_frag},normal:{uniforms:fn([fe.common,fe.bumpmap,fe.normalmap,fe.displacementmap,{opacity:{value:1}}]),vertexShader:$e.meshnormal_vert,fragmentShader:$e.meshnormal_frag},sprite:{uniforms:fn([fe.sprite,fe.fog]),vertexShader:$e.sprite_vert,fragmentShader:$e.sprite_frag},background:{uniforms:{uvTransform:{value:new Oe},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:$e.background_vert,fragmentShader:$e.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Oe}},vertexShader:$e.backgroundCube_vert,fragmentShader:$e.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:$e.cube_vert,fragmentShader:$e.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:$e.equirect_vert,fragmentShader:$e.equirect_frag},distance:{uniforms:fn([fe.common,fe.displacementmap,{referencePosition:{value:new C},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:$e.distance_vert,fragmentShader:$e.distance_frag},shadow:{uniforms:fn([fe.lights,fe.fog,{color:{value:new Fe(0)},opacity:{value:1}}]),vertexShader:$e.shadow_vert,fragmentShader:$e.shadow_frag}};bn.physical={uniforms:fn([bn.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Oe},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Oe},clearcoatNormalScale:{value:new Ge(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Oe},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new Oe},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Oe},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Oe},sheen:{value:0},sheenColor:{value:new Fe(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Oe},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Oe},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Oe},transmissionSamplerSize:{value:new Ge},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Oe},attenuationDistance:{value:0},attenuationColor:{value:new Fe(0)},specularColor:{value:new Fe(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Oe},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Oe},anisotropyVector:{value:new Ge},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Oe}}]),vertexShader:$e.meshphysical_vert,fragmentShader:$e.meshphysical_frag};var su={r:0,b:0,g:0},QS=new Qe,Cg=new Oe;Cg.set(-1,0,0,0,1,0,0,0,1);function e1(n,e,t,i,s,r){let o=new Fe(0),a=s===!0?0:1,l,c,u=null,h=0,d=null;function f(y){let v=y.isScene===!0?y.background:null;if(v&&v.isTexture){let M=y.backgroundBlurriness>0;v=e.get(v,M)}return v}function p(y){let v=!1,M=f(y);M===null?m(o,a):M&&M.isColor&&(m(M,1),v=!0);let w=n.xr.getEnvironmentBlendMode();w==="additive"?t.buffers.color.setClear(0,0,0,1,r):w==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||v)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function x(y,v){let M=f(v);M&&M.isCubeTexture?(c===void 0&&(c=new Ye(new Ki(1,1,1),new ni({name:"BackgroundCubeMaterial",uniforms:lr(bn.backgroundCube.uniforms),vertexShader:bn.backgroundCube.vertexShader,fragmentShader:bn.backgroundCube.fragmentShader,side:Mn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(w,E,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=M,c.material.uniforms.backgroundBlurriness.value=v.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=v.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(QS.makeRotationFromEuler(v.backgroundRotation)).transpose(),M.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Cg),c.material.toneMapped=Je.getTransfer(M.colorSpace)!==st,(u!==M||h!==M.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,u=M,h=M.version,d=n.toneMapping),c.layers.enableAll(),y.unshift(c,c.geometry,c.material,0,0,null)):M&&M.isTexture&&(l===void 0&&(l=new Ye(new ir(2,2),new ni({name:"BackgroundMaterial",uniforms:lr(bn.background.uniforms),vertexShader:bn.background.vertexShader,fragmentShader:bn.background.fragmentShader,side:Ts,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=M,l.material.uniforms.backgroundIntensity.value=v.backgroundIntensity,l.material.toneMapped=Je.getTransfer(M.colorSpace)!==st,M.matrixAutoUpdate===!0&&M.updateMatrix(),l.material.uniforms.uvTransform.value.copy(M.matrix),(u!==M||h!==M.version||d!==n.toneMapping)&&(l.material.needsUpdate=!0,u=M,h=M.version,d=n.toneMapping),l.layers.enableAll(),y.unshift(l,l.geometry,l.material,0,0,null))}function m(y,v){y.getRGB(su,Od(n)),t.buffers.color.setClear(su.r,su.g,su.b,v,r)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(y,v=1){o.set(y),a=v,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(y){a=y,m(o,a)},render:p,addToRenderList:x,dispose:g}}function t1(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=d(null),r=s,o=!1;function a(L,D,B,P,O){let H=!1,V=h(L,P,B,D);r!==V&&(r=V,c(r.object)),H=f(L,P,B,O),H&&p(L,P,B,O),O!==null&&e.update(O,n.ELEMENT_ARRAY_BUFFER),(H||o)&&(o=!1,M(L,D,B,P),O!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(O).buffer))}function l(){return n.createVertexArray()}function c(L){return n.bindVertexArray(L)}function u(L){return n.deleteVertexArray(L)}function h(L,D,B,P){let O=P.wireframe===!0,H=i[D.id];H===void 0&&(H={},i[D.id]=H);let V=L.isInstancedMesh===!0?L.id:0,ee=H[V];ee===void 0&&(ee={},H[V]=ee);let X=ee[B.id];X===void 0&&(X={},ee[B.id]=X);let j=X[O];return j===void 0&&(j=d(l()),X[O]=j),j}function d(L){let D=[],B=[],P=[];for(let O=0;O<t;O++)D[O]=0,B[O]=0,P[O]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:D,enabledAttributes:B,attributeDivisors:P,object:L,attributes:{},index:null}}function f(L,D,B,P){let O=r.attributes,H=D.attributes,V=0,ee=B.getAttributes();for(let X in ee)if(ee[X].location>=0){let te=O[X],ve=H[X];if(ve===void 0&&(X==="instanceMatrix"&&L.instanceMatrix&&(ve=L.instanceMatrix),X==="instanceColor"&&L.instanceColor&&(ve=L.instanceColor)),te===void 0||te.attribute!==ve||ve&&te.data!==ve.data)return!0;V++}return r.attributesNum!==V||r.index!==P}function p(L,D,B,P){let O={},H=D.attributes,V=0,ee=B.getAttributes();for(let X in ee)if(ee[X].location>=0){let te=H[X];te===void 0&&(X==="instanceMatrix"&&L.instanceMatrix&&(te=L.instanceMatrix),X==="instanceColor"&&L.instanceColor&&(te=L.instanceColor));let ve={};ve.attribute=te,te&&te.data&&(ve.data=te.data),O[X]=ve,V++}r.attributes=O,r.attributesNum=V,r.index=P}function x(){let L=r.newAttributes;for(let D=0,B=L.length;D<B;D++)L[D]=0}function m(L){g(L,0)}function g(L,D){let B=r.newAttributes,P=r.enabledAttributes,O=r.attributeDivisors;B[L]=1,P[L]===0&&(n.enableVertexAttribArray(L),P[L]=1),O[L]!==D&&(n.vertexAttribDivisor(L,D),O[L]=D)}function y(){let L=r.newAttributes,D=r.enabledAttributes;for(let B=0,P=D.length;B<P;B++)D[B]!==L[B]&&(n.disableVertexAttribArray(B),D[B]=0)}function v(L,D,B,P,O,H,V){V===!0?n.vertexAttribIPointer(L,D,B,O,H):n.vertexAttribPointer(L,D,B,P,O,H)}function M(L,D,B,P){x();let O=P.attributes,H=B.getAttributes(),V=D.defaultAttributeValues;for(let ee in H){let X=H[ee];if(X.location>=0){let j=O[ee];if(j===void 0&&(ee==="instanceMatrix"&&L.instanceMatrix&&(j=L.instanceMatrix),ee==="instanceColor"&&L.instanceColor&&(j=L.instanceColor)),j!==void 0){let te=j.normalized,ve=j.itemSize,Pe=e.get(j);if(Pe===void 0)continue;let Y=Pe.buffer,me=Pe.type,Me=Pe.bytesPerElement,Le=me===n.INT||me===n.UNSIGNED_INT||j.gpuType===_c;if(j.isInterleavedBufferAttribute){let ye=j.data,ze=ye.isInterleavedBuffer===!0?ye.stride:ye.itemSize,Pt=j.offset;if(ye.isInstancedInterleavedBuffer||ye.isInstancedBufferAttribute){for(let De=0;De<X.locationSize;De++)g(X.location+De,ye.meshPerAttribute);L.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=ye.meshPerAttribute*ye.count)}else for(let De=0;De<X.locationSize;De++)m(X.location+De);n.bindBuffer(n.ARRAY_BUFFER,Y);for(let De=0;De<X.locationSize;De++)v(X.location+De,ve/X.locationSize,me,te,ze*Me,(Pt+ve/X.locationSize*De)*Me,Le)}else{if(j.isInstancedBufferAttribute){for(let ye=0;ye<X.locationSize;ye++)g(X.location+ye,j.meshPerAttribute);L.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=j.meshPerAttribute*j.count)}else for(let ye=0;ye<X.locationSize;ye++)m(X.location+ye);n.bindBuffer(n.ARRAY_BUFFER,Y);for(let ye=0;ye<X.locationSize;ye++)v(X.location+ye,ve/X.locationSize,me,te,ve*Me,ve/X.locationSize*ye*Me,Le)}}else if(V!==void 0){let te=V[ee];if(te!==void 0)switch(te.length){case 2:n.vertexAttrib2fv(X.location,te);break;case 3:n.vertexAttrib3fv(X.location,te);break;case 4:n.vertexAttrib4fv(X.location,te);break;default:n.vertexAttrib1fv(X.location,te)}}}}y()}function w(){I();for(let L in i){let D=i[L];for(let B in D){let P=D[B];for(let O in P){let H=P[O];for(let V in H)u(H[V].object),delete H[V];delete P[O]}}delete i[L]}}function E(L){if(i[L.id]===void 0)return;let D=i[L.id];for(let B in D){let P=D[B];for(let O in P){let H=P[O];for(let V in H)u(H[V].object),delete H[V];delete P[O]}}delete i[L.id]}function _(L){for(let D in i){let B=i[D];for(let P in B){let O=B[P];if(O[L.id]===void 0)continue;let H=O[L.id];for(let V in H)u(H[V].object),delete H[V];delete O[L.id]}}}function b(L){for(let D in i){let B=i[D],P=L.isInstancedMesh===!0?L.id:0,O=B[P];if(O!==void 0){for(let H in O){let V=O[H];for(let ee in V)u(V[ee].object),delete V[ee];delete O[H]}delete B[P],Object.keys(B).length===0&&delete i[D]}}}function I(){T(),o=!0,r!==s&&(r=s,c(r.object))}function T(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:I,resetDefaultState:T,dispose:w,releaseStatesOfGeometry:E,releaseStatesOfObject:b,releaseStatesOfProgram:_,initAttributes:x,enableAttribute:m,disableUnusedAttributes:y}}function n1(n,e,t){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),t.update(c,i,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let d=0;for(let f=0;f<u;f++)d+=c[f];t.update(d,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function i1(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let _=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(_){return!(_!==gi&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let b=_===mi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(_!==Dn&&_!==ii&&!b&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(_){if(_==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(Ie("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),d=t.logarithmicDepthBuffer===!0&&h===!1;t.reversedDepthBuffer===!0&&h===!1&&Ie("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&h===!0&&Ie("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),p=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),g=n.getParameter(n.MAX_VERTEX_ATTRIBS),y=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),v=n.getParameter(n.MAX_VARYING_VECTORS),M=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),w=n.getParameter(n.MAX_SAMPLES),E=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:h,maxTextures:f,maxVertexTextures:p,maxTextureSize:x,maxCubemapSize:m,maxAttributes:g,maxVertexUniforms:y,maxVaryings:v,maxFragmentUniforms:M,maxSamples:w,samples:E}}function s1(n){let e=this,t=null,i=0,s=!1,r=!1,o=new hi,a=new Oe,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,d){let f=h.length!==0||d||i!==0||s;return s=d,i=h.length,f},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,d){t=u(h,d,0)},this.setState=function(h,d,f){let p=h.clippingPlanes,x=h.clipIntersection,m=h.clipShadows,g=n.get(h);if(!s||p===null||p.length===0||r&&!m)r?u(null):c();else{let y=r?0:i,v=y*4,M=g.clippingState||null;l.value=M,M=u(p,d,v,f);for(let w=0;w!==v;++w)M[w]=t[w];g.clippingState=M,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=y}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(h,d,f,p){let x=h!==null?h.length:0,m=null;if(x!==0){if(m=l.value,p!==!0||m===null){let g=f+x*4,y=d.matrixWorldInverse;a.getNormalMatrix(y),(m===null||m.length<g)&&(m=new Float32Array(g));for(let v=0,M=f;v!==x;++v,M+=4)o.copy(h[v]).applyMatrix4(y,a),o.normal.toArray(m,M),m[M+3]=o.constant}l.value=m,l.needsUpdate=!0}return e.numPlanes=x,e.numIntersection=0,m}}var Ta=class extends kn{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new Qo(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new Ki(5,5,5),r=new ni({name:"CubemapFromEquirect",uniforms:lr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Mn,blending:sr});r.uniforms.tEquirect.value=t;let o=new Ye(s,r),a=t.minFilter;return t.minFilter===Ji&&(t.minFilter=Ft),new Yr(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}},ag=256,r1=3,o1=20,Ig=256,Pg=16,a1=3,l1=new C,c1=new Fe,ou=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Yr(1,10,null),this._boxMesh=new Ye(new Ki(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){let{size:o=256,position:a=l1}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,p=l.autoClearStencil,x=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,x===null&&(e.background=l.getClearColor(c1));let m=new Yr(i,s,u);return m.position.copy(a),m.update(l,e),l.autoClear=h,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=p,e.background=x,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=ug(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=cg(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(ag,Dd(e))}_fromTexture(e,t){e.mapping===or||e.mapping===Kr?this._setSize(e.image.length===0?ag:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=lg(e,!1,!1),i=Math.log2(e)-r1;for(let s=0;s<=i;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=lg(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===or||e.mapping===Kr?(this._cubemapMaterial===null&&(this._cubemapMaterial=ug()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=cg()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=u1(),this._integrationMaterial=h1());let t=this._cubeSize,i=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/Pg);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-a1)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(Ig*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=d1());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,i),s.envMap.value=e.texture,this._renderCube(r,0,i)}};function lg(n,e,t){return new Ta(n,{minFilter:Ji,generateMipmaps:e,type:mi,colorSpace:Go,depthBuffer:t})}function Ra(n,e,t){return new ni({name:n,uniforms:e,vertexShader:$e.cube_vert,fragmentShader:t,side:Mn,blending:sr,depthTest:!1,depthWrite:!1})}function u1(){return Ra("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Ig}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function h1(){return Ra("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Pg}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function d1(){return Ra("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${o1}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function cg(){return Ra("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function ug(){return Ra("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function f1(n){let e=new WeakMap,t=new WeakMap,i=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===gc||f===xc)if(e.has(d)){let p=e.get(d).texture;return a(p,d.mapping)}else{let p=d.image;if(p&&p.height>0){let x=new Ta(p.height);return x.fromEquirectangularTexture(n,d),e.set(d,x),d.addEventListener("dispose",c),a(x.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,p=f===gc||f===xc,x=f===or||f===Kr;if(p||x){let m=t.get(d),g=m!==void 0?m.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==g)return i===null&&(i=new ou(n)),m=p?i.fromEquirectangular(d,m):i.fromCubemap(d,m),m.texture.pmremVersion=d.pmremVersion,t.set(d,m),m.texture;if(m!==void 0)return m.texture;{let y=d.image;return p&&y&&y.height>0||x&&y&&l(y)?(i===null&&(i=new ou(n)),m=p?i.fromEquirectangular(d):i.fromCubemap(d),m.texture.pmremVersion=d.pmremVersion,t.set(d,m),d.addEventListener("dispose",u),m.texture):null}}}return d}function a(d,f){return f===gc?d.mapping=or:f===xc&&(d.mapping=Kr),d}function l(d){let f=0,p=6;for(let x=0;x<p;x++)d[x]!==void 0&&f++;return f===p}function c(d){let f=d.target;f.removeEventListener("dispose",c);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function u(d){let f=d.target;f.removeEventListener("dispose",u);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function h(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:h}}function p1(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let s=t(i);return s===null&&Bo("WebGLRenderer: "+i+" extension not supported."),s}}}function m1(n,e,t,i){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&e.remove(p.index);for(let m in p.attributes)e.remove(p.attributes[m]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let x=r.get(p);x&&(e.remove(x),r.delete(p)),i.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,t.memory.geometries--}function c(p,x){return s[x.id]!==void 0||(x.addEventListener("dispose",a),s[x.id]=new WeakRef(x),o.register(x,x.id,x),t.memory.geometries++),x}function u(p){let x=p.attributes;for(let m in x)e.update(x[m],n.ARRAY_BUFFER)}function h(p){let x=p.index,m=p.attributes.position,g=0;if(m===void 0)return;let y=x!==null?x.array.length:m.array.length/3-1,v=m.count>=65535?Zo:Yo,M=new v(Math.ceil(y/3)*6,1),w=M.array;if(x!==null){let _=x.array;g=x.version;for(let b=0,I=0;b<y;b+=3){let T=_[b+0],L=_[b+1],D=_[b+2];w[I++]=T,w[I++]=L,w[I++]=L,w[I++]=D,w[I++]=D,w[I++]=T}}else{g=m.version;for(let _=0,b=0;_<y;_+=3){let I=_+0,T=_+1,L=_+2;w[b++]=I,w[b++]=T,w[b++]=T,w[b++]=L,w[b++]=L,w[b++]=I}}M.version=g;let E=r.get(p);E&&e.remove(E),r.set(p,M)}function d(p){let x=r.get(p);if(x){let m=p.index;m!==null&&x.version<m.version&&h(p)}else h(p);return r.get(p)}function f(){for(let p in s){let x=s[p].deref();x!==void 0&&l(x)}}return{get:c,update:u,getWireframeAttribute:d,dispose:f}}function g1(n,e,t){let i;function s(h){i=h}let r,o;function a(h){r=h.type,o=h.bytesPerElement}function l(h,d){n.drawElements(i,d,r,h*o),t.update(d,i,1)}function c(h,d,f){f!==0&&(n.drawElementsInstanced(i,d,r,h*o,f),t.update(d,i,f))}function u(h,d,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,r,h,0,f);let x=0;for(let m=0;m<f;m++)x+=d[m];t.update(x,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function x1(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:Ue("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function y1(n,e,t){let i=new WeakMap,s=new ot;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,d=i.get(a);if(d===void 0||d.count!==h){let I=function(){_.dispose(),i.delete(a),a.removeEventListener("dispose",I)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,x=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],y=a.morphAttributes.color||[],v=0;f===!0&&(v=1),p===!0&&(v=2),x===!0&&(v=3);let M=a.attributes.position.count*v,w=1;M>e.maxTextureSize&&(w=Math.ceil(M/e.maxTextureSize),M=e.maxTextureSize);let E=new Float32Array(M*w*4*h),_=new qo(E,M,w,h);_.type=ii,_.needsUpdate=!0;let b=v*4;for(let T=0;T<h;T++){let L=m[T],D=g[T],B=y[T],P=M*w*4*T;for(let O=0;O<L.count;O++){let H=O*b;f===!0&&(s.fromBufferAttribute(L,O),E[P+H+0]=s.x,E[P+H+1]=s.y,E[P+H+2]=s.z,E[P+H+3]=0),p===!0&&(s.fromBufferAttribute(D,O),E[P+H+4]=s.x,E[P+H+5]=s.y,E[P+H+6]=s.z,E[P+H+7]=0),x===!0&&(s.fromBufferAttribute(B,O),E[P+H+8]=s.x,E[P+H+9]=s.y,E[P+H+10]=s.z,E[P+H+11]=B.itemSize===4?s.w:1)}}d={count:h,texture:_,size:new Ge(M,w)},i.set(a,d),a.addEventListener("dispose",I)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let f=0;for(let x=0;x<c.length;x++)f+=c[x];let p=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(n,"morphTargetBaseInfluence",p),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",d.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",d.size)}return{update:r}}function _1(n,e,t,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,h=c.geometry,d=e.get(c,h);if(r.get(d)!==u&&(e.update(d),r.set(d,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==u&&(f.update(),r.set(f,u))}return d}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var v1={[pd]:"LINEAR_TONE_MAPPING",[md]:"REINHARD_TONE_MAPPING",[gd]:"CINEON_TONE_MAPPING",[xd]:"ACES_FILMIC_TONE_MAPPING",[_d]:"AGX_TONE_MAPPING",[vd]:"NEUTRAL_TONE_MAPPING",[yd]:"CUSTOM_TONE_MAPPING"};function M1(n,e,t,i,s,r){let o=new kn(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new xt;u.setAttribute("position",new tt([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new tt([0,2,0,0,2,0],2));let h=new tc({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),d=new Ye(u,h),f=new ua(-1,1,1,-1,0,1),p=null,x=null,m=!1,g,y=null,v=[],M=!1;this.setSize=function(w,E){o.setSize(w,E),a!==null&&a.setSize(w,E),l!==null&&l.setSize(w,E);for(let _=0;_<v.length;_++){let b=v[_];b.setSize&&b.setSize(w,E)}},this.setEffects=function(w){v=w,M=v.length>0&&v[0].isRenderPass===!0;let E=o.width,_=o.height;v.length>0&&a===null&&(a=new kn(E,_,{type:mi,depthBuffer:!1,stencilBuffer:!1}),l=new kn(E,_,{type:mi,depthBuffer:!1,stencilBuffer:!1}));let b=s===!0&&v.some(I=>I.needsDepthTexture===!0);b!==(o.depthTexture!==null)&&(b===!0&&c===null&&(c=new ji(E,_),r===!0&&(c.format=Qi,c.type=ar)),o.dispose(),o.depthTexture=b?c:null,o.resolveDepthBuffer=b,o.storeMultisampledDepthBuffer=b);for(let I=0;I<v.length;I++){let T=v[I];T.setSize&&T.setSize(E,_),b&&T.needsDepthTexture===!0&&T.setDepthTexture&&T.setDepthTexture(c)}},this.begin=function(w,E){if(m||w.toneMapping===Ri&&v.length===0)return!1;if(y=E,E!==null){let _=E.width,b=E.height;(o.width!==_||o.height!==b)&&this.setSize(_,b)}return M===!1&&w.setRenderTarget(o),g=w.toneMapping,w.toneMapping=Ri,!0},this.hasRenderPass=function(){return M},this.end=function(w,E){w.toneMapping=g,m=!0;let _=o,b=a;for(let I=0;I<v.length;I++){let T=v[I];T.enabled!==!1&&(T.render(w,b,_,E),T.needsSwap!==!1&&(_=b,b=b===a?l:a))}if(p!==w.outputColorSpace||x!==w.toneMapping){p=w.outputColorSpace,x=w.toneMapping,h.defines={},Je.getTransfer(p)===st&&(h.defines.SRGB_TRANSFER="");let I=v1[x];I&&(h.defines[I]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=_.texture,w.setRenderTarget(y),w.render(d,f),y=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var Lg=new Ln,Ng=new ji(1,1),Dg=new ea(1),Ug=new qo,Fg=new jl,Og=new Qo,hg=[],dg=[],fg=new Float32Array(16),pg=new Float32Array(9),mg=new Float32Array(4);function to(n,e,t){let i=n[0];if(i<=0||i>0)return n;let s=e*t,r=hg[s];if(r===void 0&&(r=new Float32Array(s),hg[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function Ot(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function Bt(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function lu(n,e){let t=dg[e];t===void 0&&(t=new Int32Array(e),dg[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function b1(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function S1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Ot(t,e))return;n.uniform2fv(this.addr,e),Bt(t,e)}}function w1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Ot(t,e))return;n.uniform3fv(this.addr,e),Bt(t,e)}}function A1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Ot(t,e))return;n.uniform4fv(this.addr,e),Bt(t,e)}}function E1(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Ot(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),Bt(t,e)}else{if(Ot(t,i))return;mg.set(i),n.uniformMatrix2fv(this.addr,!1,mg),Bt(t,i)}}function T1(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Ot(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),Bt(t,e)}else{if(Ot(t,i))return;pg.set(i),n.uniformMatrix3fv(this.addr,!1,pg),Bt(t,i)}}function R1(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Ot(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),Bt(t,e)}else{if(Ot(t,i))return;fg.set(i),n.uniformMatrix4fv(this.addr,!1,fg),Bt(t,i)}}function C1(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function I1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Ot(t,e))return;n.uniform2iv(this.addr,e),Bt(t,e)}}function P1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Ot(t,e))return;n.uniform3iv(this.addr,e),Bt(t,e)}}function L1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Ot(t,e))return;n.uniform4iv(this.addr,e),Bt(t,e)}}function N1(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function D1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Ot(t,e))return;n.uniform2uiv(this.addr,e),Bt(t,e)}}function U1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Ot(t,e))return;n.uniform3uiv(this.addr,e),Bt(t,e)}}function F1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Ot(t,e))return;n.uniform4uiv(this.addr,e),Bt(t,e)}}function cu(n){return n.version===0&&(n.compareFunction=Id,n.needsUpdate=!0),n}function O1(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=cu(Ng):r=Lg,t.setTexture2D(e||r,s)}function B1(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||Fg,s)}function k1(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=cu(Dg):r=Og,t.setTextureCube(e||r,s)}function z1(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||Ug,s)}function G1(n){switch(n){case 5126:return b1;case 35664:return S1;case 35665:return w1;case 35666:return A1;case 35674:return E1;case 35675:return T1;case 35676:return R1;case 5124:case 35670:return C1;case 35667:case 35671:return I1;case 35668:case 35672:return P1;case 35669:case 35673:return L1;case 5125:return N1;case 36294:return D1;case 36295:return U1;case 36296:return F1;case 35678:case 36198:case 36298:case 36306:case 35682:return O1;case 35679:case 36299:case 36307:return B1;case 35680:case 36300:case 36308:case 36293:return k1;case 36289:case 36303:case 36311:case 36292:return z1}}function V1(n,e){n.uniform1fv(this.addr,e)}function H1(n,e){let t=to(e,this.size,2);n.uniform2fv(this.addr,t)}function W1(n,e){let t=to(e,this.size,3);n.uniform3fv(this.addr,t)}function q1(n,e){let t=to(e,this.size,4);n.uniform4fv(this.addr,t)}function X1(n,e){let t=to(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function $1(n,e){let t=to(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function Y1(n,e){let t=to(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function Z1(n,e){n.uniform1iv(this.addr,e)}function j1(n,e){n.uniform2iv(this.addr,e)}function K1(n,e){n.uniform3iv(this.addr,e)}function J1(n,e){n.uniform4iv(this.addr,e)}function Q1(n,e){n.uniform1uiv(this.addr,e)}function ew(n,e){n.uniform2uiv(this.addr,e)}function tw(n,e){n.uniform3uiv(this.addr,e)}function nw(n,e){n.uniform4uiv(this.addr,e)}function iw(n,e,t){let i=this.cache,s=e.length,r=lu(t,s);Ot(i,r)||(n.uniform1iv(this.addr,r),Bt(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=cu(Ng):o=Lg;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function sw(n,e,t){let i=this.cache,s=e.length,r=lu(t,s);Ot(i,r)||(n.uniform1iv(this.addr,r),Bt(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||Fg,r[o])}function rw(n,e,t){let i=this.cache,s=e.length,r=lu(t,s);Ot(i,r)||(n.uniform1iv(this.addr,r),Bt(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=cu(Dg):o=Og;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function ow(n,e,t){let i=this.cache,s=e.length,r=lu(t,s);Ot(i,r)||(n.uniform1iv(this.addr,r),Bt(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||Ug,r[o])}function aw(n){switch(n){case 5126:return V1;case 35664:return H1;case 35665:return W1;case 35666:return q1;case 35674:return X1;case 35675:return $1;case 35676:return Y1;case 5124:case 35670:return Z1;case 35667:case 35671:return j1;case 35668:case 35672:return K1;case 35669:case 35673:return J1;case 5125:return Q1;case 36294:return ew;case 36295:return tw;case 36296:return nw;case 35678:case 36198:case 36298:case 36306:case 35682:return iw;case 35679:case 36299:case 36307:return sw;case 35680:case 36300:case 36308:case 36293:return rw;case 36289:case 36303:case 36311:case 36292:return ow}}var Hd=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=G1(t.type)}},Wd=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=aw(t.type)}},qd=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],i)}}},Gd=/(\w+)(\])?(\[|\.)?/g;function gg(n,e){n.seq.push(e),n.map[e.id]=e}function lw(n,e,t){let i=n.name,s=i.length;for(Gd.lastIndex=0;;){let r=Gd.exec(i),o=Gd.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){gg(t,c===void 0?new Hd(a,n,e):new Wd(a,n,e));break}else{let h=t.map[a];h===void 0&&(h=new qd(a),gg(t,h)),t=h}}}var eo=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);lw(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){let r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){let s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let i=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&i.push(o)}return i}};function xg(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var cw=37297,uw=0;function hw(n,e){let t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var yg=new Oe;function dw(n){Je._getMatrix(yg,Je.workingColorSpace,n);let e=`mat3( ${yg.elements.map(t=>t.toFixed(4))} )`;switch(Je.getTransfer(n)){case Vo:return[e,"LinearTransferOETF"];case st:return[e,"sRGBTransferOETF"];default:return Ie("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function _g(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+hw(n.getShaderSource(e),a)}else return r}function fw(n,e){let t=dw(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var pw={[pd]:"Linear",[md]:"Reinhard",[gd]:"Cineon",[xd]:"ACESFilmic",[_d]:"AgX",[vd]:"Neutral",[yd]:"Custom"};function mw(n,e){let t=pw[e];return t===void 0?(Ie("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var ru=new C;function gw(){Je.getLuminanceCoefficients(ru);let n=ru.x.toFixed(4),e=ru.y.toFixed(4),t=ru.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function xw(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Ea).join(`
`)}function yw(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function _w(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(e,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function Ea(n){return n!==""}function vg(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function Mg(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var vw=/^[ \t]*#include +<([\w\d./]+)>/gm;function Xd(n){return n.replace(vw,Mw)}function Mw(n,e){let t=$e[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Xd(t)}var bw=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function bg(n){return n.replace(bw,Sw)}function Sw(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Sg(n){let e=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?e+=`
#define HIGH_PRECISION`:n.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var ww={[ma]:"SHADOWMAP_TYPE_PCF",[Zr]:"SHADOWMAP_TYPE_VSM"};function Aw(n){return ww[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var Ew={[Kr]:"ENVMAP_MODE_REFRACTION"};function Tw(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":Ew[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var Rw={[ga]:"ENVMAP_BLENDING_MULTIPLY",[Hm]:"ENVMAP_BLENDING_MIX",[Wm]:"ENVMAP_BLENDING_ADD"};function Cw(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":Rw[n.combine]||"ENVMAP_BLENDING_NONE"}function Iw(n,e,t,i){let s=n.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=Aw(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=Tw(t),h=Cw(t),d=xw(t),f=yw(r),p=s.createProgram(),x,m,g=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(x=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(Ea).join(`
`),x.length>0&&(x+=`
`),m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(Ea).join(`
`),m.length>0&&(m+=`
`)):(x=[Sg(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Ea).join(`
`),m=[Sg(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+h:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==Ri?"#define TONE_MAPPING":"",t.toneMapping!==Ri?$e.tonemapping_pars_fragment:"",t.toneMapping!==Ri?mw("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",$e.colorspace_pars_fragment,fw("linearToOutputTexel",t.outputColorSpace),gw(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Ea).join(`
`)),o=Xd(o),o=vg(o,t),o=Mg(o,t),a=Xd(a),a=vg(a,t),a=Mg(a,t),o=bg(o),a=bg(a),t.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,x=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+x,m=["#define varying in",t.glslVersion===Ld?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Ld?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let y=g+x+o,v=g+m+a,M=xg(s,s.VERTEX_SHADER,y),w=xg(s,s.FRAGMENT_SHADER,v);s.attachShader(p,M),s.attachShader(p,w),t.index0AttributeName!==void 0?s.bindAttribLocation(p,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function E(T){if(n.debug.checkShaderErrors){let L=s.getProgramInfoLog(p)||"",D=s.getShaderInfoLog(M)||"",B=s.getShaderInfoLog(w)||"",P=L.trim(),O=D.trim(),H=B.trim(),V=!0,ee=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(V=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,p,M,w);else{let X=_g(s,M,"vertex"),j=_g(s,w,"fragment");Ue("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+T.name+`
Material Type: `+T.type+`

Program Info Log: `+P+`
`+X+`
`+j)}else P!==""?Ie("WebGLProgram: Program Info Log:",P):(O===""||H==="")&&(ee=!1);ee&&(T.diagnostics={runnable:V,programLog:P,vertexShader:{log:O,prefix:x},fragmentShader:{log:H,prefix:m}})}s.deleteShader(M),s.deleteShader(w),_=new eo(s,p),b=_w(s,p)}let _;this.getUniforms=function(){return _===void 0&&E(this),_};let b;this.getAttributes=function(){return b===void 0&&E(this),b};let I=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return I===!1&&(I=s.getProgramParameter(p,cw)),I},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=uw++,this.cacheKey=e,this.usedTimes=1,this.program=p,this.vertexShader=M,this.fragmentShader=w,this}var Pw=0,$d=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new Yd(e),t.set(e,i)),i}},Yd=class{constructor(e){this.id=Pw++,this.code=e,this.usedTimes=0}};function Lw(n){return n===Rs||n===ba||n===Sa}function Nw(n,e,t,i,s,r){let o=new Xo,a=new $d,l=new Set,c=[],u=new Map,h=i.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(_){return l.add(_),_===0?"uv":`uv${_}`}function p(_,b,I,T,L,D){let B=T.fog,P=L.geometry,O=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?T.environment:null,H=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,V=e.get(_.envMap||O,H),ee=d[_.type],X=i.precision;_.precision!==null&&(X=i.getMaxPrecision(_.precision),X!==_.precision&&Ie("WebGLProgram.getParameters:",_.precision,"not supported, using",X,"instead."));let j=P.morphAttributes.position||P.morphAttributes.normal||P.morphAttributes.color,te=j!==void 0?j.length:0,ve=0;P.morphAttributes.position!==void 0&&(ve=1),P.morphAttributes.normal!==void 0&&(ve=2),P.morphAttributes.color!==void 0&&(ve=3);let Pe,Y,me,Me;if(ee){let ge=bn[ee];Pe=ge.vertexShader,Y=ge.fragmentShader}else{Pe=_.vertexShader,Y=_.fragmentShader;let ge=a.getVertexShaderStage(_),ct=a.getFragmentShaderStage(_);a.update(_,ge,ct),me=ge.id,Me=ct.id}let Le=n.getRenderTarget(),ye=n.state.buffers.depth.getReversed(),ze=L.isInstancedMesh===!0,Pt=L.isBatchedMesh===!0,De=!!_.map,lt=!!_.matcap,ft=!!V,Ze=ft&&V.isPMREMTexture===!0,Qt=!!_.aoMap,Dt=!!_.lightMap,In=!!_.bumpMap&&_.wireframe===!1,Et=!!_.normalMap,bi=!!_.displacementMap,Vt=!!_.emissiveMap,Yn=!!_.metalnessMap,Zn=!!_.roughnessMap,jn=_.anisotropy>0,F=_.clearcoat>0,Kn=_.diffuseRoughness>0,bt=_.dispersion>0,St=_.retroreflectivity>0,pe=_.iridescence>0,Ut=_.sheen>0,Ne=_.transmission>0,Be=jn&&!!_.anisotropyMap,R=F&&!!_.clearcoatMap,S=F&&!!_.clearcoatNormalMap,z=F&&!!_.clearcoatRoughnessMap,ne=Kn&&!!_.diffuseRoughnessMap,Q=pe&&!!_.iridescenceMap,re=pe&&!!_.iridescenceThicknessMap,ue=Ut&&!!_.sheenColorMap,Z=Ut&&!!_.sheenRoughnessMap,K=!!_.specularMap,ae=!!_.specularColorMap,N=!!_.specularIntensityMap,J=Ne&&!!_.transmissionMap,$=Ne&&!!_.thicknessMap,le=!!_.gradientMap,se=!!_.alphaMap,oe=_.alphaTest>0,Re=!!_.alphaHash,Xe=!!_.extensions,ie=Ri;_.toneMapped&&(Le===null||Le.isXRRenderTarget===!0)&&(ie=n.toneMapping);let Ce=Ze?V.isCompressedCubeTexture?V.image[0].mipmaps:V.mipmaps:null,We={shaderID:ee,shaderType:_.type,shaderName:_.name,vertexShader:Pe,fragmentShader:Y,defines:_.defines,customVertexShaderID:me,customFragmentShaderID:Me,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:X,batching:Pt,batchingColor:Pt&&L._colorsTexture!==null,instancing:ze,instancingColor:ze&&L.instanceColor!==null,instancingMorph:ze&&L.morphTexture!==null,outputColorSpace:Le===null?n.outputColorSpace:Le.isXRRenderTarget===!0?Le.texture.colorSpace:Je.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:De,matcap:lt,envMap:ft,envMapMode:ft&&V.mapping,envMapPMREM:Ze,envMapMaxLod:Ze?Ce.length-1:null,envMapSize:Ze?Ce[0].width:null,aoMap:Qt,lightMap:Dt,bumpMap:In,normalMap:Et,displacementMap:bi,emissiveMap:Vt,normalMapObjectSpace:Et&&_.normalMapType===$m,normalMapTangentSpace:Et&&_.normalMapType===Qr,packedNormalMap:Et&&_.normalMapType===Qr&&Lw(_.normalMap.format),metalnessMap:Yn,roughnessMap:Zn,anisotropy:jn,anisotropyMap:Be,clearcoat:F,clearcoatMap:R,clearcoatNormalMap:S,clearcoatRoughnessMap:z,diffuseRoughness:Kn,diffuseRoughnessMap:ne,dispersion:bt,retroreflection:St,iridescence:pe,iridescenceMap:Q,iridescenceThicknessMap:re,sheen:Ut,sheenColorMap:ue,sheenRoughnessMap:Z,specularMap:K,specularColorMap:ae,specularIntensityMap:N,transmission:Ne,transmissionMap:J,thicknessMap:$,gradientMap:le,opaque:_.transparent===!1&&_.blending===jr&&_.alphaToCoverage===!1,alphaMap:se,alphaTest:oe,alphaHash:Re,combine:_.combine,mapUv:De&&f(_.map.channel),aoMapUv:Qt&&f(_.aoMap.channel),lightMapUv:Dt&&f(_.lightMap.channel),bumpMapUv:In&&f(_.bumpMap.channel),normalMapUv:Et&&f(_.normalMap.channel),displacementMapUv:bi&&f(_.displacementMap.channel),emissiveMapUv:Vt&&f(_.emissiveMap.channel),metalnessMapUv:Yn&&f(_.metalnessMap.channel),roughnessMapUv:Zn&&f(_.roughnessMap.channel),anisotropyMapUv:Be&&f(_.anisotropyMap.channel),clearcoatMapUv:R&&f(_.clearcoatMap.channel),clearcoatNormalMapUv:S&&f(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:z&&f(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ne&&f(_.diffuseRoughnessMap.channel),iridescenceMapUv:Q&&f(_.iridescenceMap.channel),iridescenceThicknessMapUv:re&&f(_.iridescenceThicknessMap.channel),sheenColorMapUv:ue&&f(_.sheenColorMap.channel),sheenRoughnessMapUv:Z&&f(_.sheenRoughnessMap.channel),specularMapUv:K&&f(_.specularMap.channel),specularColorMapUv:ae&&f(_.specularColorMap.channel),specularIntensityMapUv:N&&f(_.specularIntensityMap.channel),transmissionMapUv:J&&f(_.transmissionMap.channel),thicknessMapUv:$&&f(_.thicknessMap.channel),alphaMapUv:se&&f(_.alphaMap.channel),vertexTangents:!!P.attributes.tangent&&(Et||jn),vertexNormals:!!P.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!P.attributes.color&&P.attributes.color.itemSize===4,pointsUvs:L.isPoints===!0&&!!P.attributes.uv&&(De||se),fog:!!B,useFog:_.fog===!0,fogExp2:!!B&&B.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||P.attributes.normal===void 0&&Et===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:ye,skinning:L.isSkinnedMesh===!0,hasPositionAttribute:P.attributes.position!==void 0,morphTargets:P.morphAttributes.position!==void 0,morphNormals:P.morphAttributes.normal!==void 0,morphColors:P.morphAttributes.color!==void 0,morphTargetsCount:te,morphTextureStride:ve,numSunLights:b.sun.length,numDirLights:b.directional.length,numPointLights:b.point.length,numSpotLights:b.spot.length,numSpotLightMaps:b.spotLightMap.length,numRectAreaLights:b.rectArea.length,numHemiLights:b.hemi.length,numSunLightShadows:b.sunShadowMap.length,numDirLightShadows:b.directionalShadowMap.length,numPointLightShadows:b.pointShadowMap.length,numSpotLightShadows:b.spotShadowMap.length,numSpotLightShadowsWithMaps:b.numSpotLightShadowsWithMaps,numLightProbes:b.numLightProbes,numLightProbeGrids:D.filter(ge=>ge.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:n.shadowMap.enabled&&I.length>0,shadowMapType:n.shadowMap.type,toneMapping:ie,decodeVideoTexture:De&&_.map.isVideoTexture===!0&&Je.getTransfer(_.map.colorSpace)===st,decodeVideoTextureEmissive:Vt&&_.emissiveMap.isVideoTexture===!0&&Je.getTransfer(_.emissiveMap.colorSpace)===st,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===Ti,flipSided:_.side===Mn,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:Xe&&_.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Xe&&_.extensions.multiDraw===!0||Pt)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return We.vertexUv1s=l.has(1),We.vertexUv2s=l.has(2),We.vertexUv3s=l.has(3),l.clear(),We}function x(_){let b=[];if(_.shaderID?b.push(_.shaderID):(b.push(_.customVertexShaderID),b.push(_.customFragmentShaderID)),_.defines!==void 0)for(let I in _.defines)b.push(I),b.push(_.defines[I]);return _.isRawShaderMaterial===!1&&(m(b,_),g(b,_),b.push(n.outputColorSpace)),b.push(_.customProgramCacheKey),b.join()}function m(_,b){_.push(b.precision),_.push(b.outputColorSpace),_.push(b.envMapMode),_.push(b.envMapPMREM),_.push(b.envMapMaxLod),_.push(b.envMapSize),_.push(b.mapUv),_.push(b.alphaMapUv),_.push(b.lightMapUv),_.push(b.aoMapUv),_.push(b.bumpMapUv),_.push(b.normalMapUv),_.push(b.displacementMapUv),_.push(b.emissiveMapUv),_.push(b.metalnessMapUv),_.push(b.roughnessMapUv),_.push(b.anisotropyMapUv),_.push(b.clearcoatMapUv),_.push(b.clearcoatNormalMapUv),_.push(b.clearcoatRoughnessMapUv),_.push(b.diffuseRoughnessMapUv),_.push(b.iridescenceMapUv),_.push(b.iridescenceThicknessMapUv),_.push(b.sheenColorMapUv),_.push(b.sheenRoughnessMapUv),_.push(b.specularMapUv),_.push(b.specularColorMapUv),_.push(b.specularIntensityMapUv),_.push(b.transmissionMapUv),_.push(b.thicknessMapUv),_.push(b.combine),_.push(b.fogExp2),_.push(b.sizeAttenuation),_.push(b.morphTargetsCount),_.push(b.numSunLights),_.push(b.numDirLights),_.push(b.numPointLights),_.push(b.numSpotLights),_.push(b.numSpotLightMaps),_.push(b.numHemiLights),_.push(b.numRectAreaLights),_.push(b.numSunLightShadows),_.push(b.numDirLightShadows),_.push(b.numPointLightShadows),_.push(b.numSpotLightShadows),_.push(b.numSpotLightShadowsWithMaps),_.push(b.numLightProbes),_.push(b.numLightProbeGrids),_.push(b.shadowMapType),_.push(b.toneMapping),_.push(b.numClippingPlanes),_.push(b.numClipIntersection),_.push(b.depthPacking)}function g(_,b){o.disableAll(),b.instancing&&o.enable(0),b.instancingColor&&o.enable(1),b.instancingMorph&&o.enable(2),b.matcap&&o.enable(3),b.envMap&&o.enable(4),b.normalMapObjectSpace&&o.enable(5),b.normalMapTangentSpace&&o.enable(6),b.clearcoat&&o.enable(7),b.iridescence&&o.enable(8),b.alphaTest&&o.enable(9),b.vertexColors&&o.enable(10),b.vertexAlphas&&o.enable(11),b.vertexUv1s&&o.enable(12),b.vertexUv2s&&o.enable(13),b.vertexUv3s&&o.enable(14),b.vertexTangents&&o.enable(15),b.anisotropy&&o.enable(16),b.alphaHash&&o.enable(17),b.batching&&o.enable(18),b.dispersion&&o.enable(19),b.retroreflection&&o.enable(24),b.diffuseRoughness&&o.enable(25),b.batchingColor&&o.enable(20),b.gradientMap&&o.enable(21),b.packedNormalMap&&o.enable(22),b.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),b.fog&&o.enable(0),b.useFog&&o.enable(1),b.flatShading&&o.enable(2),b.logarithmicDepthBuffer&&o.enable(3),b.reversedDepthBuffer&&o.enable(4),b.skinning&&o.enable(5),b.morphTargets&&o.enable(6),b.morphNormals&&o.enable(7),b.morphColors&&o.enable(8),b.premultipliedAlpha&&o.enable(9),b.shadowMapEnabled&&o.enable(10),b.doubleSided&&o.enable(11),b.flipSided&&o.enable(12),b.useDepthPacking&&o.enable(13),b.dithering&&o.enable(14),b.transmission&&o.enable(15),b.sheen&&o.enable(16),b.opaque&&o.enable(17),b.pointsUvs&&o.enable(18),b.decodeVideoTexture&&o.enable(19),b.decodeVideoTextureEmissive&&o.enable(20),b.alphaToCoverage&&o.enable(21),b.numLightProbeGrids>0&&o.enable(22),b.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function y(_){let b=d[_.type],I;if(b){let T=bn[b];I=wa.clone(T.uniforms)}else I=_.uniforms;return I}function v(_,b){let I=u.get(b);return I!==void 0?++I.usedTimes:(I=new Iw(n,b,_,s),c.push(I),u.set(b,I)),I}function M(_){if(--_.usedTimes===0){let b=c.indexOf(_);c[b]=c[c.length-1],c.pop(),u.delete(_.cacheKey),_.destroy()}}function w(_){a.remove(_)}function E(){a.dispose()}return{getParameters:p,getProgramCacheKey:x,getUniforms:y,acquireProgram:v,releaseProgram:M,releaseShaderCache:w,programs:c,dispose:E}}function Dw(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function Uw(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function wg(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function Ag(){let n=[],e=0,t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,p,x,m,g){let y=n[e];return y===void 0?(y={id:d.id,object:d,geometry:f,material:p,materialVariant:o(d),groupOrder:x,renderOrder:d.renderOrder,z:m,group:g},n[e]=y):(y.id=d.id,y.object=d,y.geometry=f,y.material=p,y.materialVariant=o(d),y.groupOrder=x,y.renderOrder=d.renderOrder,y.z=m,y.group=g),e++,y}function l(d,f,p,x,m,g,y){y.reversedDepth===!0&&(m=-m);let v=a(d,f,p,x,m,g);p.transmission>0?i.push(v):p.transparent===!0?s.push(v):t.push(v)}function c(d,f,p,x,m,g){let y=a(d,f,p,x,m,g);p.transmission>0?i.unshift(y):p.transparent===!0?s.unshift(y):t.unshift(y)}function u(d,f){t.length>1&&t.sort(d||Uw),i.length>1&&i.sort(f||wg),s.length>1&&s.sort(f||wg)}function h(){for(let d=e,f=n.length;d<f;d++){let p=n[d];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:h,sort:u}}function Fw(){let n=new WeakMap;function e(i,s){let r=n.get(i),o;return r===void 0?(o=new Ag,n.set(i,[o])):s>=r.length?(o=new Ag,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function Ow(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new C,color:new Fe};break;case"SpotLight":t={position:new C,direction:new C,color:new Fe,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new C,color:new Fe,distance:0,decay:0};break;case"HemisphereLight":t={direction:new C,skyColor:new Fe,groundColor:new Fe};break;case"RectAreaLight":t={color:new Fe,position:new C,halfWidth:new C,halfHeight:new C};break}return n[e.id]=t,t}}}function Bw(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ge};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ge};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ge,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var kw=0;function zw(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function Gw(n){let e=new Ow,t=Bw(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new C);let s=new C,r=new Qe,o=new Qe;function a(c){let u=0,h=0,d=0;for(let D=0;D<9;D++)i.probe[D].set(0,0,0);let f=0,p=0,x=0,m=0,g=0,y=0,v=0,M=0,w=0,E=0,_=0,b=0,I=0,T=0;c.sort(zw);for(let D=0,B=c.length;D<B;D++){let P=c[D],O=P.color,H=P.intensity,V=P.distance,ee=null;if(P.shadow&&P.shadow.map&&(P.shadow.map.texture.format===Rs?ee=P.shadow.map.texture:ee=P.shadow.map.depthTexture||P.shadow.map.texture),P.isAmbientLight)u+=O.r*H,h+=O.g*H,d+=O.b*H;else if(P.isLightProbe){for(let X=0;X<9;X++)i.probe[X].addScaledVector(P.sh.coefficients[X],H);T++}else if(P.isSunLight){let X=e.get(P);if(X.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){let j=P.shadow,te=t.get(P);te.shadowIntensity=j.intensity,te.shadowBias=j.bias,te.shadowNormalBias=j.normalBias,te.shadowRadius=j.radius,te.shadowMapSize.copy(j.mapSize).multiply(j.getFrameExtents()),i.sunShadow[p]=te,i.sunShadowMap[p]=ee;let ve=j.getViewportCount();for(let Pe=0;Pe<ve;Pe++)i.sunShadowMatrix[x+Pe]=j.getMatrix(Pe),i.sunShadowCascade[x+Pe]=j._cascadeData[Pe];x+=ve,p++}i.sun[f]=X,f++}else if(P.isDirectionalLight){let X=e.get(P);if(X.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){let j=P.shadow,te=t.get(P);te.shadowIntensity=j.intensity,te.shadowBias=j.bias,te.shadowNormalBias=j.normalBias,te.shadowRadius=j.radius,te.shadowMapSize=j.mapSize,i.directionalShadow[m]=te,i.directionalShadowMap[m]=ee,i.directionalShadowMatrix[m]=P.shadow.matrix,w++}i.directional[m]=X,m++}else if(P.isSpotLight){let X=e.get(P);X.position.setFromMatrixPosition(P.matrixWorld),X.color.copy(O).multiplyScalar(H),X.distance=V,X.coneCos=Math.cos(P.angle),X.penumbraCos=Math.cos(P.angle*(1-P.penumbra)),X.decay=P.decay,i.spot[y]=X;let j=P.shadow;if(P.map&&(i.spotLightMap[b]=P.map,b++,j.updateMatrices(P),P.castShadow&&I++),i.spotLightMatrix[y]=j.matrix,P.castShadow){let te=t.get(P);te.shadowIntensity=j.intensity,te.shadowBias=j.bias,te.shadowNormalBias=j.normalBias,te.shadowRadius=j.radius,te.shadowMapSize=j.mapSize,i.spotShadow[y]=te,i.spotShadowMap[y]=ee,_++}y++}else if(P.isRectAreaLight){let X=e.get(P);X.color.copy(O).multiplyScalar(H),X.halfWidth.set(P.width*.5,0,0),X.halfHeight.set(0,P.height*.5,0),i.rectArea[v]=X,v++}else if(P.isPointLight){let X=e.get(P);if(X.color.copy(P.color).multiplyScalar(P.intensity),X.distance=P.distance,X.decay=P.decay,P.castShadow){let j=P.shadow,te=t.get(P);te.shadowIntensity=j.intensity,te.shadowBias=j.bias,te.shadowNormalBias=j.normalBias,te.shadowRadius=j.radius,te.shadowMapSize=j.mapSize,te.shadowCameraNear=j.camera.near,te.shadowCameraFar=j.camera.far,i.pointShadow[g]=te,i.pointShadowMap[g]=ee,i.pointShadowMatrix[g]=P.shadow.matrix,E++}i.point[g]=X,g++}else if(P.isHemisphereLight){let X=e.get(P);X.skyColor.copy(P.color).multiplyScalar(H),X.groundColor.copy(P.groundColor).multiplyScalar(H),i.hemi[M]=X,M++}}v>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=fe.LTC_FLOAT_1,i.rectAreaLTC2=fe.LTC_FLOAT_2):(i.rectAreaLTC1=fe.LTC_HALF_1,i.rectAreaLTC2=fe.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=d;let L=i.hash;(L.sunLength!==f||L.directionalLength!==m||L.pointLength!==g||L.spotLength!==y||L.rectAreaLength!==v||L.hemiLength!==M||L.numSunShadows!==p||L.numDirectionalShadows!==w||L.numPointShadows!==E||L.numSpotShadows!==_||L.numSpotMaps!==b||L.numLightProbes!==T)&&(i.sun.length=f,i.directional.length=m,i.spot.length=y,i.rectArea.length=v,i.point.length=g,i.hemi.length=M,i.sunShadow.length=p,i.sunShadowMap.length=p,i.sunShadowMatrix.length=x,i.sunShadowCascade.length=x,i.directionalShadow.length=w,i.directionalShadowMap.length=w,i.directionalShadowMatrix.length=w,i.pointShadow.length=E,i.pointShadowMap.length=E,i.pointShadowMatrix.length=E,i.spotShadow.length=_,i.spotShadowMap.length=_,i.spotLightMatrix.length=_+b-I,i.spotLightMap.length=b,i.numSpotLightShadowsWithMaps=I,i.numLightProbes=T,L.sunLength=f,L.directionalLength=m,L.pointLength=g,L.spotLength=y,L.rectAreaLength=v,L.hemiLength=M,L.numSunShadows=p,L.numDirectionalShadows=w,L.numPointShadows=E,L.numSpotShadows=_,L.numSpotMaps=b,L.numLightProbes=T,i.version=kw++)}function l(c,u){let h=0,d=0,f=0,p=0,x=0,m=0,g=u.matrixWorldInverse;for(let y=0,v=c.length;y<v;y++){let M=c[y];if(M.isSunLight){let w=i.sun[h];w.direction.setFromMatrixPosition(M.matrixWorld),w.direction.transformDirection(g),h++}else if(M.isDirectionalLight){let w=i.directional[d];w.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),w.direction.sub(s),w.direction.transformDirection(g),d++}else if(M.isSpotLight){let w=i.spot[p];w.position.setFromMatrixPosition(M.matrixWorld),w.position.applyMatrix4(g),w.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),w.direction.sub(s),w.direction.transformDirection(g),p++}else if(M.isRectAreaLight){let w=i.rectArea[x];w.position.setFromMatrixPosition(M.matrixWorld),w.position.applyMatrix4(g),o.identity(),r.copy(M.matrixWorld),r.premultiply(g),o.extractRotation(r),w.halfWidth.set(M.width*.5,0,0),w.halfHeight.set(0,M.height*.5,0),w.halfWidth.applyMatrix4(o),w.halfHeight.applyMatrix4(o),x++}else if(M.isPointLight){let w=i.point[f];w.position.setFromMatrixPosition(M.matrixWorld),w.position.applyMatrix4(g),f++}else if(M.isHemisphereLight){let w=i.hemi[m];w.direction.setFromMatrixPosition(M.matrixWorld),w.direction.transformDirection(g),m++}}}return{setup:a,setupView:l,state:i}}function Eg(n){let e=new Gw(n),t=[],i=[],s=[];function r(h){u.camera=h,t.length=0,i.length=0,s.length=0}function o(h){h.isLightProbeGrid?s.push(h):t.push(h)}function a(h){i.push(h)}function l(){e.setup(t),s.sort((h,d)=>h.priority-d.priority||h.id-d.id)}function c(h){e.setupView(t,h)}let u={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function Vw(n){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new Eg(n),e.set(s,[a])):r>=o.length?(a=new Eg(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var Hw=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,Ww=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,qw=[new C(1,0,0),new C(-1,0,0),new C(0,1,0),new C(0,-1,0),new C(0,0,1),new C(0,0,-1)],Xw=[new C(0,-1,0),new C(0,-1,0),new C(0,0,1),new C(0,0,-1),new C(0,-1,0),new C(0,-1,0)],Tg=new Qe,Aa=new C,Vd=new C;function $w(n,e,t){let i=new vs,s=new Ge,r=new Ge,o=new ot,a=new nc,l=new ic,c={},u=t.maxTextureSize,h={[Ts]:Mn,[Mn]:Ts,[Ti]:Ti},d=new ni({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Ge},radius:{value:4}},vertexShader:Hw,fragmentShader:Ww}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let p=new xt;p.setAttribute("position",new Rt(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new Ye(p,d),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=ma;let g=this.type;this.render=function(E,_,b){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||E.length===0)return;this.type===wm&&(Ie("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=ma);let I=n.getRenderTarget(),T=n.getActiveCubeFace(),L=n.getActiveMipmapLevel(),D=n.state;D.setBlending(sr),D.buffers.depth.getReversed()===!0?D.buffers.color.setClear(0,0,0,0):D.buffers.color.setClear(1,1,1,1),D.buffers.depth.setTest(!0),D.setScissorTest(!1);let B=g!==this.type;B&&_.traverse(function(P){P.material&&(Array.isArray(P.material)?P.material.forEach(O=>O.needsUpdate=!0):P.material.needsUpdate=!0)});for(let P=0,O=E.length;P<O;P++){let H=E[P],V=H.shadow;if(V===void 0){Ie("WebGLShadowMap:",H,"has no shadow.");continue}if(V.autoUpdate===!1&&V.needsUpdate===!1)continue;s.copy(V.mapSize);let ee=V.getFrameExtents();s.multiply(ee),r.copy(V.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/ee.x),s.x=r.x*ee.x,V.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/ee.y),s.y=r.y*ee.y,V.mapSize.y=r.y));let X=n.state.buffers.depth.getReversed();if(V.camera._reversedDepth=X,V.map===null||B===!0){if(V.map!==null&&(V.map.depthTexture!==null&&(V.map.depthTexture.dispose(),V.map.depthTexture=null),V.map.dispose()),this.type===Zr){if(H.isPointLight){Ie("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}V.map=new kn(s.x,s.y,{format:Rs,type:mi,minFilter:Ft,magFilter:Ft,generateMipmaps:!1}),V.map.texture.name=H.name+".shadowMap",V.map.depthTexture=new ji(s.x,s.y,ii),V.map.depthTexture.name=H.name+".shadowMapDepth",V.map.depthTexture.format=Zi,V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=Xt,V.map.depthTexture.magFilter=Xt}else H.isPointLight?(V.map=new Ta(s.x),V.map.depthTexture=new ea(s.x,pi)):(V.map=new kn(s.x,s.y),V.map.depthTexture=new ji(s.x,s.y,pi)),V.map.depthTexture.name=H.name+".shadowMap",V.map.depthTexture.format=Zi,this.type===ma?(V.map.depthTexture.compareFunction=X?Cd:Rd,V.map.depthTexture.minFilter=Ft,V.map.depthTexture.magFilter=Ft):(V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=Xt,V.map.depthTexture.magFilter=Xt);V.camera.updateProjectionMatrix()}V.map.isWebGLCubeRenderTarget!==!0&&(V.map.width!==s.x||V.map.height!==s.y)&&V.map.setSize(s.x,s.y);let j=V.map.isWebGLCubeRenderTarget?6:V.getViewportCount();H.isPointLight!==!0&&V.updateMatrices(H,b);let te=(V.camera.layers.mask&4294967294)!==0?V.camera.layers:b.layers;for(let ve=0;ve<j;ve++){let Pe=V.getCamera(ve);if(H.isPointLight){let Y=V.camera,me=V.matrix,Me=H.distance||Y.far;Me!==Y.far&&(Y.far=Me,Y.updateProjectionMatrix()),Aa.setFromMatrixPosition(H.matrixWorld),Y.position.copy(Aa),Vd.copy(Y.position),Vd.add(qw[ve]),Y.up.copy(Xw[ve]),Y.lookAt(Vd),Y.updateMatrixWorld(),me.makeTranslation(-Aa.x,-Aa.y,-Aa.z),Tg.multiplyMatrices(Y.projectionMatrix,Y.matrixWorldInverse),V._frustum.setFromProjectionMatrix(Tg,Y.coordinateSystem,Y.reversedDepth)}if(V.map.isWebGLCubeRenderTarget)n.setRenderTarget(V.map,ve),n.clear();else{ve===0&&(n.setRenderTarget(V.map),n.clear());let Y=V.getViewport(ve);o.set(r.x*Y.x,r.y*Y.y,r.x*Y.z,r.y*Y.w),D.viewport(o)}i=V.getFrustum(ve),M(_,b,Pe,H,te,this.type)}V.isPointLightShadow!==!0&&this.type===Zr&&y(V,b),V.needsUpdate=!1}g=this.type,m.needsUpdate=!1,n.setRenderTarget(I,T,L)};function y(E,_){let b=e.update(x);d.defines.VSM_SAMPLES!==E.blurSamples&&(d.defines.VSM_SAMPLES=E.blurSamples,f.defines.VSM_SAMPLES=E.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),E.mapPass===null?E.mapPass=new kn(s.x,s.y,{format:Rs,type:mi}):(E.mapPass.width!==E.map.width||E.mapPass.height!==E.map.height)&&E.mapPass.setSize(E.map.width,E.map.height),d.uniforms.shadow_pass.value=E.map.depthTexture,d.uniforms.resolution.value.set(E.map.width,E.map.height),d.uniforms.radius.value=E.radius,n.setRenderTarget(E.mapPass),n.clear(),n.renderBufferDirect(_,null,b,d,x,null),f.uniforms.shadow_pass.value=E.mapPass.texture,f.uniforms.resolution.value.set(E.map.width,E.map.height),f.uniforms.radius.value=E.radius,n.setRenderTarget(E.map),n.clear(),n.renderBufferDirect(_,null,b,f,x,null)}function v(E,_,b,I){let T=null,L=b.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(L!==void 0)T=L;else if(T=b.isPointLight===!0?l:a,n.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let D=T.uuid,B=_.uuid,P=c[D];P===void 0&&(P={},c[D]=P);let O=P[B];O===void 0&&(O=T.clone(),P[B]=O,_.addEventListener("dispose",w)),T=O}if(T.visible=_.visible,T.wireframe=_.wireframe,I===Zr?T.side=_.shadowSide!==null?_.shadowSide:_.side:T.side=_.shadowSide!==null?_.shadowSide:h[_.side],T.alphaMap=_.alphaMap,T.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,T.map=_.map,T.clipShadows=_.clipShadows,T.clippingPlanes=_.clippingPlanes,T.clipIntersection=_.clipIntersection,T.displacementMap=_.displacementMap,T.displacementScale=_.displacementScale,T.displacementBias=_.displacementBias,T.wireframeLinewidth=_.wireframeLinewidth,T.linewidth=_.linewidth,b.isPointLight===!0&&T.isMeshDistanceMaterial===!0){let D=n.properties.get(T);D.light=b}return T}function M(E,_,b,I,T,L){if(E.visible===!1)return;if(E.layers.test(T)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&L===Zr)&&(!E.frustumCulled||E.intersectsFrustum(i))){E.modelViewMatrix.multiplyMatrices(b.matrixWorldInverse,E.matrixWorld);let P=e.update(E),O=E.material;if(Array.isArray(O)){let H=P.groups;for(let V=0,ee=H.length;V<ee;V++){let X=H[V],j=O[X.materialIndex];if(j&&j.visible){let te=v(E,j,I,L);E.onBeforeShadow(n,E,_,b,P,te,X),n.renderBufferDirect(b,null,P,te,E,X),E.onAfterShadow(n,E,_,b,P,te,X)}}}else if(O.visible){let H=v(E,O,I,L);E.onBeforeShadow(n,E,_,b,P,H,null),n.renderBufferDirect(b,null,P,H,E,null),E.onAfterShadow(n,E,_,b,P,H,null)}}let B=E.children;for(let P=0,O=B.length;P<O;P++)M(B[P],_,b,I,T,L)}function w(E){E.target.removeEventListener("dispose",w);for(let b in c){let I=c[b],T=E.target.uuid;T in I&&(I[T].dispose(),delete I[T])}}}function Yw(n,e){function t(){let N=!1,J=new ot,$=null,le=new ot(0,0,0,0);return{setMask:function(se){$!==se&&!N&&(n.colorMask(se,se,se,se),$=se)},setLocked:function(se){N=se},setClear:function(se,oe,Re,Xe,ie){ie===!0&&(se*=Xe,oe*=Xe,Re*=Xe),J.set(se,oe,Re,Xe),le.equals(J)===!1&&(n.clearColor(se,oe,Re,Xe),le.copy(J))},reset:function(){N=!1,$=null,le.set(-1,0,0,0)}}}function i(){let N=!1,J=!1,$=null,le=null,se=null;return{setReversed:function(oe){if(J!==oe){let Re=e.get("EXT_clip_control");oe?Re.clipControlEXT(Re.LOWER_LEFT_EXT,Re.ZERO_TO_ONE_EXT):Re.clipControlEXT(Re.LOWER_LEFT_EXT,Re.NEGATIVE_ONE_TO_ONE_EXT),J=oe;let Xe=se;se=null,this.setClear(Xe)}},getReversed:function(){return J},setTest:function(oe){oe?ye(n.DEPTH_TEST):ze(n.DEPTH_TEST)},setMask:function(oe){$!==oe&&!N&&(n.depthMask(oe),$=oe)},setFunc:function(oe){if(J&&(oe=ig[oe]),le!==oe){switch(oe){case Bl:n.depthFunc(n.NEVER);break;case kl:n.depthFunc(n.ALWAYS);break;case zl:n.depthFunc(n.LESS);break;case Or:n.depthFunc(n.LEQUAL);break;case Gl:n.depthFunc(n.EQUAL);break;case Vl:n.depthFunc(n.GEQUAL);break;case Hl:n.depthFunc(n.GREATER);break;case Wl:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}le=oe}},setLocked:function(oe){N=oe},setClear:function(oe){se!==oe&&(se=oe,J&&(oe=1-oe),n.clearDepth(oe))},reset:function(){N=!1,$=null,le=null,se=null,J=!1}}}function s(){let N=!1,J=null,$=null,le=null,se=null,oe=null,Re=null,Xe=null,ie=null;return{setTest:function(Ce){N||(Ce?ye(n.STENCIL_TEST):ze(n.STENCIL_TEST))},setMask:function(Ce){J!==Ce&&!N&&(n.stencilMask(Ce),J=Ce)},setFunc:function(Ce,We,ge){($!==Ce||le!==We||se!==ge)&&(n.stencilFunc(Ce,We,ge),$=Ce,le=We,se=ge)},setOp:function(Ce,We,ge){(oe!==Ce||Re!==We||Xe!==ge)&&(n.stencilOp(Ce,We,ge),oe=Ce,Re=We,Xe=ge)},setLocked:function(Ce){N=Ce},setClear:function(Ce){ie!==Ce&&(n.clearStencil(Ce),ie=Ce)},reset:function(){N=!1,J=null,$=null,le=null,se=null,oe=null,Re=null,Xe=null,ie=null}}}let r=new t,o=new i,a=new s,l={},c=new WeakMap,u={},h={},d={},f=new WeakMap,p=[],x=null,m=!1,g=null,y=null,v=null,M=null,w=null,E=null,_=null,b=new Fe(0,0,0),I=0,T=!1,L=null,D=null,B=null,P=null,O=null,H=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),V=!1,ee=0,X=n.getParameter(n.VERSION);X.indexOf("WebGL")!==-1?(ee=parseFloat(/^WebGL (\d)/.exec(X)[1]),V=ee>=1):X.indexOf("OpenGL ES")!==-1&&(ee=parseFloat(/^OpenGL ES (\d)/.exec(X)[1]),V=ee>=2);let j=null,te={},ve=n.getParameter(n.SCISSOR_BOX),Pe=n.getParameter(n.VIEWPORT),Y=new ot().fromArray(ve),me=new ot().fromArray(Pe);function Me(N,J,$,le){let se=new Uint8Array(4),oe=n.createTexture();n.bindTexture(N,oe),n.texParameteri(N,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(N,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Re=0;Re<$;Re++)N===n.TEXTURE_3D||N===n.TEXTURE_2D_ARRAY?n.texImage3D(J,0,n.RGBA,1,1,le,0,n.RGBA,n.UNSIGNED_BYTE,se):n.texImage2D(J+Re,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,se);return oe}let Le={};Le[n.TEXTURE_2D]=Me(n.TEXTURE_2D,n.TEXTURE_2D,1),Le[n.TEXTURE_CUBE_MAP]=Me(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Le[n.TEXTURE_2D_ARRAY]=Me(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Le[n.TEXTURE_3D]=Me(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),ye(n.DEPTH_TEST),o.setFunc(Or),In(!1),Et(ld),ye(n.CULL_FACE),Qt(sr);function ye(N){u[N]!==!0&&(n.enable(N),u[N]=!0)}function ze(N){u[N]!==!1&&(n.disable(N),u[N]=!1)}function Pt(N,J){return d[N]!==J?(n.bindFramebuffer(N,J),d[N]=J,N===n.DRAW_FRAMEBUFFER&&(d[n.FRAMEBUFFER]=J),N===n.FRAMEBUFFER&&(d[n.DRAW_FRAMEBUFFER]=J),!0):!1}function De(N,J){let $=p,le=!1;if(N){$=f.get(J),$===void 0&&($=[],f.set(J,$));let se=N.textures;if($.length!==se.length||$[0]!==n.COLOR_ATTACHMENT0){for(let oe=0,Re=se.length;oe<Re;oe++)$[oe]=n.COLOR_ATTACHMENT0+oe;$.length=se.length,le=!0}}else $[0]!==n.BACK&&($[0]=n.BACK,le=!0);le&&n.drawBuffers($)}function lt(N){return x!==N?(n.useProgram(N),x=N,!0):!1}let ft={[rr]:n.FUNC_ADD,[Em]:n.FUNC_SUBTRACT,[Tm]:n.FUNC_REVERSE_SUBTRACT};ft[Rm]=n.MIN,ft[Cm]=n.MAX;let Ze={[Im]:n.ZERO,[Pm]:n.ONE,[Lm]:n.SRC_COLOR,[dd]:n.SRC_ALPHA,[Bm]:n.SRC_ALPHA_SATURATE,[Fm]:n.DST_COLOR,[Dm]:n.DST_ALPHA,[Nm]:n.ONE_MINUS_SRC_COLOR,[fd]:n.ONE_MINUS_SRC_ALPHA,[Om]:n.ONE_MINUS_DST_COLOR,[Um]:n.ONE_MINUS_DST_ALPHA,[km]:n.CONSTANT_COLOR,[zm]:n.ONE_MINUS_CONSTANT_COLOR,[Gm]:n.CONSTANT_ALPHA,[Vm]:n.ONE_MINUS_CONSTANT_ALPHA};function Qt(N,J,$,le,se,oe,Re,Xe,ie,Ce){if(N===sr){m===!0&&(ze(n.BLEND),m=!1);return}if(m===!1&&(ye(n.BLEND),m=!0),N!==Am){if(N!==g||Ce!==T){if((y!==rr||w!==rr)&&(n.blendEquation(n.FUNC_ADD),y=rr,w=rr),Ce)switch(N){case jr:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case cd:n.blendFunc(n.ONE,n.ONE);break;case ud:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case hd:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:Ue("WebGLState: Invalid blending: ",N);break}else switch(N){case jr:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case cd:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case ud:Ue("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case hd:Ue("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Ue("WebGLState: Invalid blending: ",N);break}v=null,M=null,E=null,_=null,b.set(0,0,0),I=0,g=N,T=Ce}return}se=se||J,oe=oe||$,Re=Re||le,(J!==y||se!==w)&&(n.blendEquationSeparate(ft[J],ft[se]),y=J,w=se),($!==v||le!==M||oe!==E||Re!==_)&&(n.blendFuncSeparate(Ze[$],Ze[le],Ze[oe],Ze[Re]),v=$,M=le,E=oe,_=Re),(Xe.equals(b)===!1||ie!==I)&&(n.blendColor(Xe.r,Xe.g,Xe.b,ie),b.copy(Xe),I=ie),g=N,T=!1}function Dt(N,J){N.side===Ti?ze(n.CULL_FACE):ye(n.CULL_FACE);let $=N.side===Mn;J&&($=!$),In($),N.blending===jr&&N.transparent===!1?Qt(sr):Qt(N.blending,N.blendEquation,N.blendSrc,N.blendDst,N.blendEquationAlpha,N.blendSrcAlpha,N.blendDstAlpha,N.blendColor,N.blendAlpha,N.premultipliedAlpha),o.setFunc(N.depthFunc),o.setTest(N.depthTest),o.setMask(N.depthWrite),r.setMask(N.colorWrite);let le=N.stencilWrite;a.setTest(le),le&&(a.setMask(N.stencilWriteMask),a.setFunc(N.stencilFunc,N.stencilRef,N.stencilFuncMask),a.setOp(N.stencilFail,N.stencilZFail,N.stencilZPass)),Vt(N.polygonOffset,N.polygonOffsetFactor,N.polygonOffsetUnits),N.alphaToCoverage===!0?ye(n.SAMPLE_ALPHA_TO_COVERAGE):ze(n.SAMPLE_ALPHA_TO_COVERAGE)}function In(N){L!==N&&(N?n.frontFace(n.CW):n.frontFace(n.CCW),L=N)}function Et(N){N!==bm?(ye(n.CULL_FACE),N!==D&&(N===ld?n.cullFace(n.BACK):N===Sm?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):ze(n.CULL_FACE),D=N}function bi(N){N!==B&&(V&&n.lineWidth(N),B=N)}function Vt(N,J,$){N?(ye(n.POLYGON_OFFSET_FILL),(P!==J||O!==$)&&(P=J,O=$,o.getReversed()&&(J=-J,$=-$),n.polygonOffset(J,$))):ze(n.POLYGON_OFFSET_FILL)}function Yn(N){N?ye(n.SCISSOR_TEST):ze(n.SCISSOR_TEST)}function Zn(N){N===void 0&&(N=n.TEXTURE0+H-1),j!==N&&(n.activeTexture(N),j=N)}function jn(N,J,$){$===void 0&&(j===null?$=n.TEXTURE0+H-1:$=j);let le=te[$];le===void 0&&(le={type:void 0,texture:void 0},te[$]=le),(le.type!==N||le.texture!==J)&&(j!==$&&(n.activeTexture($),j=$),n.bindTexture(N,J||Le[N]),le.type=N,le.texture=J)}function F(){let N=te[j];N!==void 0&&N.type!==void 0&&(n.bindTexture(N.type,null),N.type=void 0,N.texture=void 0)}function Kn(){try{n.compressedTexImage2D(...arguments)}catch(N){Ue("WebGLState:",N)}}function bt(){try{n.compressedTexImage3D(...arguments)}catch(N){Ue("WebGLState:",N)}}function St(){try{n.texSubImage2D(...arguments)}catch(N){Ue("WebGLState:",N)}}function pe(){try{n.texSubImage3D(...arguments)}catch(N){Ue("WebGLState:",N)}}function Ut(){try{n.compressedTexSubImage2D(...arguments)}catch(N){Ue("WebGLState:",N)}}function Ne(){try{n.compressedTexSubImage3D(...arguments)}catch(N){Ue("WebGLState:",N)}}function Be(){try{n.texStorage2D(...arguments)}catch(N){Ue("WebGLState:",N)}}function R(){try{n.texStorage3D(...arguments)}catch(N){Ue("WebGLState:",N)}}function S(){try{n.texImage2D(...arguments)}catch(N){Ue("WebGLState:",N)}}function z(){try{n.texImage3D(...arguments)}catch(N){Ue("WebGLState:",N)}}function ne(N){return h[N]!==void 0?h[N]:n.getParameter(N)}function Q(N,J){h[N]!==J&&(n.pixelStorei(N,J),h[N]=J)}function re(N){Y.equals(N)===!1&&(n.scissor(N.x,N.y,N.z,N.w),Y.copy(N))}function ue(N){me.equals(N)===!1&&(n.viewport(N.x,N.y,N.z,N.w),me.copy(N))}function Z(N,J){let $=c.get(J);$===void 0&&($=new WeakMap,c.set(J,$));let le=$.get(N);le===void 0&&(le=n.getUniformBlockIndex(J,N.name),n.uniformBlockBinding(J,le,le),$.set(N,le))}function K(N,J,$){let se=c.get(J).get(N);l[se]!==$&&(n.bindBufferBase(n.UNIFORM_BUFFER,se,$),l[se]=$)}function ae(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},h={},j=null,te={},d={},l={},f=new WeakMap,p=[],x=null,m=!1,g=null,y=null,v=null,M=null,w=null,E=null,_=null,b=new Fe(0,0,0),I=0,T=!1,L=null,D=null,B=null,P=null,O=null,Y.set(0,0,n.canvas.width,n.canvas.height),me.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:ye,disable:ze,bindFramebuffer:Pt,drawBuffers:De,useProgram:lt,setBlending:Qt,setMaterial:Dt,setFlipSided:In,setCullFace:Et,setLineWidth:bi,setPolygonOffset:Vt,setScissorTest:Yn,activeTexture:Zn,bindTexture:jn,unbindTexture:F,compressedTexImage2D:Kn,compressedTexImage3D:bt,texImage2D:S,texImage3D:z,pixelStorei:Q,getParameter:ne,updateUBOMapping:Z,uniformBlockBinding:K,texStorage2D:Be,texStorage3D:R,texSubImage2D:St,texSubImage3D:pe,compressedTexSubImage2D:Ut,compressedTexSubImage3D:Ne,scissor:re,viewport:ue,reset:ae}}function Zw(n,e,t,i,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Ge,u=new WeakMap,h=new Set,d,f=new WeakMap,p=new Set,x=new FinalizationRegistry(R=>p.delete(R)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(R,S){return m?new OffscreenCanvas(R,S):Ho("canvas")}function y(R,S,z){let ne=1,Q=Be(R);if((Q.width>z||Q.height>z)&&(ne=z/Math.max(Q.width,Q.height)),ne<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){let re=Math.floor(ne*Q.width),ue=Math.floor(ne*Q.height);d===void 0&&(d=g(re,ue));let Z=S?g(re,ue):d;return Z.width=re,Z.height=ue,Z.getContext("2d").drawImage(R,0,0,re,ue),Ie("WebGLRenderer: Texture has been resized from ("+Q.width+"x"+Q.height+") to ("+re+"x"+ue+")."),Z}else return"data"in R&&Ie("WebGLRenderer: Image in DataTexture is too big ("+Q.width+"x"+Q.height+")."),R;return R}function v(R){return R.generateMipmaps}function M(R){n.generateMipmap(R)}function w(R){return R.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?n.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function E(R,S,z,ne,Q,re=!1){if(R!==null){if(n[R]!==void 0)return n[R];Ie("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let ue;ne&&(ue=e.get("EXT_texture_norm16"),ue||Ie("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let Z=S;if(S===n.RED&&(z===n.FLOAT&&(Z=n.R32F),z===n.HALF_FLOAT&&(Z=n.R16F),z===n.UNSIGNED_BYTE&&(Z=n.R8),z===n.UNSIGNED_SHORT&&ue&&(Z=ue.R16_EXT),z===n.SHORT&&ue&&(Z=ue.R16_SNORM_EXT)),S===n.RED_INTEGER&&(z===n.UNSIGNED_BYTE&&(Z=n.R8UI),z===n.UNSIGNED_SHORT&&(Z=n.R16UI),z===n.UNSIGNED_INT&&(Z=n.R32UI),z===n.BYTE&&(Z=n.R8I),z===n.SHORT&&(Z=n.R16I),z===n.INT&&(Z=n.R32I)),S===n.RG&&(z===n.FLOAT&&(Z=n.RG32F),z===n.HALF_FLOAT&&(Z=n.RG16F),z===n.UNSIGNED_BYTE&&(Z=n.RG8),z===n.UNSIGNED_SHORT&&ue&&(Z=ue.RG16_EXT),z===n.SHORT&&ue&&(Z=ue.RG16_SNORM_EXT)),S===n.RG_INTEGER&&(z===n.UNSIGNED_BYTE&&(Z=n.RG8UI),z===n.UNSIGNED_SHORT&&(Z=n.RG16UI),z===n.UNSIGNED_INT&&(Z=n.RG32UI),z===n.BYTE&&(Z=n.RG8I),z===n.SHORT&&(Z=n.RG16I),z===n.INT&&(Z=n.RG32I)),S===n.RGB_INTEGER&&(z===n.UNSIGNED_BYTE&&(Z=n.RGB8UI),z===n.UNSIGNED_SHORT&&(Z=n.RGB16UI),z===n.UNSIGNED_INT&&(Z=n.RGB32UI),z===n.BYTE&&(Z=n.RGB8I),z===n.SHORT&&(Z=n.RGB16I),z===n.INT&&(Z=n.RGB32I)),S===n.RGBA_INTEGER&&(z===n.UNSIGNED_BYTE&&(Z=n.RGBA8UI),z===n.UNSIGNED_SHORT&&(Z=n.RGBA16UI),z===n.UNSIGNED_INT&&(Z=n.RGBA32UI),z===n.BYTE&&(Z=n.RGBA8I),z===n.SHORT&&(Z=n.RGBA16I),z===n.INT&&(Z=n.RGBA32I)),S===n.RGB&&(z===n.UNSIGNED_SHORT&&ue&&(Z=ue.RGB16_EXT),z===n.SHORT&&ue&&(Z=ue.RGB16_SNORM_EXT),z===n.UNSIGNED_INT_5_9_9_9_REV&&(Z=n.RGB9_E5),z===n.UNSIGNED_INT_10F_11F_11F_REV&&(Z=n.R11F_G11F_B10F)),S===n.RGBA){let K=re?Vo:Je.getTransfer(Q);z===n.FLOAT&&(Z=n.RGBA32F),z===n.HALF_FLOAT&&(Z=n.RGBA16F),z===n.UNSIGNED_BYTE&&(Z=K===st?n.SRGB8_ALPHA8:n.RGBA8),z===n.UNSIGNED_SHORT&&ue&&(Z=ue.RGBA16_EXT),z===n.SHORT&&ue&&(Z=ue.RGBA16_SNORM_EXT),z===n.UNSIGNED_SHORT_4_4_4_4&&(Z=n.RGBA4),z===n.UNSIGNED_SHORT_5_5_5_1&&(Z=n.RGB5_A1)}return(Z===n.R16F||Z===n.R32F||Z===n.RG16F||Z===n.RG32F||Z===n.RGBA16F||Z===n.RGBA32F)&&e.get("EXT_color_buffer_float"),Z}function _(R,S){let z;return R?S===null||S===pi||S===ar?z=n.DEPTH24_STENCIL8:S===ii?z=n.DEPTH32F_STENCIL8:S===Jr&&(z=n.DEPTH24_STENCIL8,Ie("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):S===null||S===pi||S===ar?z=n.DEPTH_COMPONENT24:S===ii?z=n.DEPTH_COMPONENT32F:S===Jr&&(z=n.DEPTH_COMPONENT16),z}function b(R,S){return v(R)===!0||R.isFramebufferTexture&&R.minFilter!==Xt&&R.minFilter!==Ft?Math.log2(Math.max(S.width,S.height))+1:R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?S.mipmaps.length:1}function I(R){let S=new WeakRef(R);i.get(R).__ref=S,p.add(S),x.register(R,S,S)}function T(R){let S=i.get(R).__ref;S!==void 0&&(p.delete(S),x.unregister(S))}function L(R){B(R.target)}function D(R){P(R.target)}function B(R){R.removeEventListener("dispose",L),T(R),H(R),R.isVideoTexture&&u.delete(R),R.isHTMLTexture&&h.delete(R)}function P(R){R.removeEventListener("dispose",D),T(R),ee(R)}function O(){for(let R of p){let S=R.deref();S!==void 0&&(S.isRenderTarget===!0?P(S):B(S))}p.clear(),h.clear()}function H(R){let S=i.get(R);if(S.__webglInit===void 0)return;let z=R.source,ne=f.get(z);if(ne){let Q=ne[S.__cacheKey];Q.usedTimes--,Q.usedTimes===0&&V(R),Object.keys(ne).length===0&&f.delete(z)}i.remove(R)}function V(R){let S=i.get(R);n.deleteTexture(S.__webglTexture);let z=R.source,ne=f.get(z);delete ne[S.__cacheKey],o.memory.textures--}function ee(R){let S=i.get(R);S.__depthDisposeCallback&&S.__depthDisposeCallback();let z=R.depthTexture;if(z&&z.renderTarget===R&&B(z),R.isWebGLCubeRenderTarget)for(let Q=0;Q<6;Q++){if(Array.isArray(S.__webglFramebuffer[Q]))for(let re=0;re<S.__webglFramebuffer[Q].length;re++)n.deleteFramebuffer(S.__webglFramebuffer[Q][re]);else n.deleteFramebuffer(S.__webglFramebuffer[Q]);S.__webglDepthbuffer&&n.deleteRenderbuffer(S.__webglDepthbuffer[Q])}else{if(Array.isArray(S.__webglFramebuffer))for(let Q=0;Q<S.__webglFramebuffer.length;Q++)n.deleteFramebuffer(S.__webglFramebuffer[Q]);else n.deleteFramebuffer(S.__webglFramebuffer);if(S.__webglDepthbuffer&&n.deleteRenderbuffer(S.__webglDepthbuffer),S.__webglMultisampledFramebuffer&&n.deleteFramebuffer(S.__webglMultisampledFramebuffer),S.__webglColorRenderbuffer)for(let Q=0;Q<S.__webglColorRenderbuffer.length;Q++)S.__webglColorRenderbuffer[Q]&&n.deleteRenderbuffer(S.__webglColorRenderbuffer[Q]);S.__webglDepthRenderbuffer&&n.deleteRenderbuffer(S.__webglDepthRenderbuffer)}let ne=R.textures;for(let Q=0,re=ne.length;Q<re;Q++){let ue=i.get(ne[Q]);ue.__webglTexture&&(n.deleteTexture(ue.__webglTexture),o.memory.textures--),i.remove(ne[Q])}i.remove(R)}let X=0;function j(){X=0}function te(){return X}function ve(R){X=R}function Pe(){let R=X;return R>=s.maxTextures&&Ie("WebGLTextures: Trying to use "+(R+1)+" texture units while this GPU supports only "+s.maxTextures),X+=1,R}function Y(R){let S=[];return S.push(R.wrapS),S.push(R.wrapT),S.push(R.wrapR||0),S.push(R.magFilter),S.push(R.minFilter),S.push(R.anisotropy),S.push(R.internalFormat),S.push(R.format),S.push(R.type),S.push(R.generateMipmaps),S.push(R.mipmapsAutoUpdate),S.push(R.premultiplyAlpha),S.push(R.flipY),S.push(R.unpackAlignment),S.push(R.colorSpace),S.join()}function me(R,S){let z=i.get(R);if(R.isVideoTexture&&Ut(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&z.__version!==R.version){let ne=R.image;if(ne===null)Ie("WebGLRenderer: Texture marked for update but no image data found.");else if(ne.complete===!1)Ie("WebGLRenderer: Texture marked for update but image is incomplete");else{Dt(z,R,S);return}}else R.isExternalTexture&&(z.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,z.__webglTexture,n.TEXTURE0+S)}function Me(R,S){let z=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&z.__version!==R.version){Dt(z,R,S);return}else R.isExternalTexture&&(z.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,z.__webglTexture,n.TEXTURE0+S)}function Le(R,S){let z=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&z.__version!==R.version){Dt(z,R,S);return}t.bindTexture(n.TEXTURE_3D,z.__webglTexture,n.TEXTURE0+S)}function ye(R,S){let z=i.get(R);if(R.version>0&&z.__version!==R.version){In(z,R,S);return}t.bindTexture(n.TEXTURE_CUBE_MAP,z.__webglTexture,n.TEXTURE0+S)}let ze={[ql]:n.REPEAT,[wi]:n.CLAMP_TO_EDGE,[Xl]:n.MIRRORED_REPEAT},Pt={[Xt]:n.NEAREST,[qm]:n.NEAREST_MIPMAP_NEAREST,[xa]:n.NEAREST_MIPMAP_LINEAR,[Ft]:n.LINEAR,[yc]:n.LINEAR_MIPMAP_NEAREST,[Ji]:n.LINEAR_MIPMAP_LINEAR},De={[Zm]:n.NEVER,[Id]:n.ALWAYS,[jm]:n.LESS,[Rd]:n.LEQUAL,[Km]:n.EQUAL,[Cd]:n.GEQUAL,[Jm]:n.GREATER,[Qm]:n.NOTEQUAL};function lt(R,S){if(S.type===ii&&e.has("OES_texture_float_linear")===!1&&(S.magFilter===Ft||S.magFilter===yc||S.magFilter===xa||S.magFilter===Ji||S.minFilter===Ft||S.minFilter===yc||S.minFilter===xa||S.minFilter===Ji)&&Ie("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(R,n.TEXTURE_WRAP_S,ze[S.wrapS]),n.texParameteri(R,n.TEXTURE_WRAP_T,ze[S.wrapT]),(R===n.TEXTURE_3D||R===n.TEXTURE_2D_ARRAY)&&n.texParameteri(R,n.TEXTURE_WRAP_R,ze[S.wrapR]),n.texParameteri(R,n.TEXTURE_MAG_FILTER,Pt[S.magFilter]),n.texParameteri(R,n.TEXTURE_MIN_FILTER,Pt[S.minFilter]),S.compareFunction&&(n.texParameteri(R,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(R,n.TEXTURE_COMPARE_FUNC,De[S.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(S.magFilter===Xt||S.minFilter!==xa&&S.minFilter!==Ji||S.type===ii&&e.has("OES_texture_float_linear")===!1)return;if(S.anisotropy>1||i.get(S).__currentAnisotropy){let z=e.get("EXT_texture_filter_anisotropic");n.texParameterf(R,z.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(S.anisotropy,s.getMaxAnisotropy())),i.get(S).__currentAnisotropy=S.anisotropy}}}function ft(R,S){let z=!1;R.__webglInit===void 0&&(R.__webglInit=!0,S.addEventListener("dispose",L),I(S));let ne=S.source,Q=f.get(ne);Q===void 0&&(Q={},f.set(ne,Q));let re=Y(S);if(re!==R.__cacheKey){Q[re]===void 0&&(Q[re]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,z=!0),Q[re].usedTimes++;let ue=Q[R.__cacheKey];ue!==void 0&&(Q[R.__cacheKey].usedTimes--,ue.usedTimes===0&&V(S)),R.__cacheKey=re,R.__webglTexture=Q[re].texture}return z}function Ze(R,S,z){return Math.floor(Math.floor(R/z)/S)}function Qt(R,S,z,ne){let re=R.updateRanges;if(re.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,S.width,S.height,z,ne,S.data);else{re.sort((N,J)=>N.start-J.start);let ue=0;for(let N=1;N<re.length;N++){let J=re[ue],$=re[N],le=J.start+J.count,se=Ze($.start,S.width,4),oe=Ze(J.start,S.width,4);$.start<=le+1&&se===oe&&Ze($.start+$.count-1,S.width,4)===se?J.count=Math.max(J.count,$.start+$.count-J.start):(++ue,re[ue]=$)}re.length=ue+1;let Z=t.getParameter(n.UNPACK_ROW_LENGTH),K=t.getParameter(n.UNPACK_SKIP_PIXELS),ae=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,S.width);for(let N=0,J=re.length;N<J;N++){let $=re[N],le=Math.floor($.start/4),se=Math.ceil($.count/4),oe=le%S.width,Re=Math.floor(le/S.width),Xe=se,ie=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,oe),t.pixelStorei(n.UNPACK_SKIP_ROWS,Re),t.texSubImage2D(n.TEXTURE_2D,0,oe,Re,Xe,ie,z,ne,S.data)}R.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,Z),t.pixelStorei(n.UNPACK_SKIP_PIXELS,K),t.pixelStorei(n.UNPACK_SKIP_ROWS,ae)}}function Dt(R,S,z){let ne=n.TEXTURE_2D;(S.isDataArrayTexture||S.isCompressedArrayTexture)&&(ne=n.TEXTURE_2D_ARRAY),S.isData3DTexture&&(ne=n.TEXTURE_3D);let Q=ft(R,S),re=S.source;t.bindTexture(ne,R.__webglTexture,n.TEXTURE0+z);let ue=i.get(re);if(re.version!==ue.__version||Q===!0){if(t.activeTexture(n.TEXTURE0+z),(typeof ImageBitmap<"u"&&S.image instanceof ImageBitmap)===!1){let ie=Je.getPrimaries(Je.workingColorSpace),Ce=S.colorSpace===es?null:Je.getPrimaries(S.colorSpace),We=S.colorSpace===es||ie===Ce?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,We)}t.pixelStorei(n.UNPACK_ALIGNMENT,S.unpackAlignment);let K=y(S.image,!1,s.maxTextureSize);K=Ne(S,K);let ae=r.convert(S.format,S.colorSpace),N=r.convert(S.type),J=E(S.internalFormat,ae,N,S.normalized,S.colorSpace,S.isVideoTexture);lt(ne,S);let $,le=S.mipmaps,se=S.isVideoTexture!==!0,oe=ue.__version===void 0||Q===!0,Re=re.dataReady,Xe=b(S,K);if(S.isDepthTexture)J=_(S.format===Qi,S.type),oe&&(se?t.texStorage2D(n.TEXTURE_2D,1,J,K.width,K.height):t.texImage2D(n.TEXTURE_2D,0,J,K.width,K.height,0,ae,N,null));else if(S.isDataTexture)if(le.length>0){se&&oe&&t.texStorage2D(n.TEXTURE_2D,Xe,J,le[0].width,le[0].height);for(let ie=0,Ce=le.length;ie<Ce;ie++)$=le[ie],se?Re&&t.texSubImage2D(n.TEXTURE_2D,ie,0,0,$.width,$.height,ae,N,$.data):t.texImage2D(n.TEXTURE_2D,ie,J,$.width,$.height,0,ae,N,$.data);S.generateMipmaps=!1}else se?(oe&&t.texStorage2D(n.TEXTURE_2D,Xe,J,K.width,K.height),Re&&Qt(S,K,ae,N)):t.texImage2D(n.TEXTURE_2D,0,J,K.width,K.height,0,ae,N,K.data);else if(S.isCompressedTexture)if(S.isCompressedArrayTexture){se&&oe&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Xe,J,le[0].width,le[0].height,K.depth);for(let ie=0,Ce=le.length;ie<Ce;ie++)if($=le[ie],S.format!==gi)if(ae!==null)if(se){if(Re)if(S.layerUpdates.size>0){let We=zd($.width,$.height,S.format,S.type);for(let ge of S.layerUpdates){let ct=$.data.subarray(ge*We/$.data.BYTES_PER_ELEMENT,(ge+1)*We/$.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ie,0,0,ge,$.width,$.height,1,ae,ct)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ie,0,0,0,$.width,$.height,K.depth,ae,$.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ie,J,$.width,$.height,K.depth,0,$.data,0,0);else Ie("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else se?Re&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,ie,0,0,0,$.width,$.height,K.depth,ae,N,$.data):t.texImage3D(n.TEXTURE_2D_ARRAY,ie,J,$.width,$.height,K.depth,0,ae,N,$.data);S.layerUpdates.size>0&&S.clearLayerUpdates()}else{se&&oe&&t.texStorage2D(n.TEXTURE_2D,Xe,J,le[0].width,le[0].height);for(let ie=0,Ce=le.length;ie<Ce;ie++)$=le[ie],S.format!==gi?ae!==null?se?Re&&t.compressedTexSubImage2D(n.TEXTURE_2D,ie,0,0,$.width,$.height,ae,$.data):t.compressedTexImage2D(n.TEXTURE_2D,ie,J,$.width,$.height,0,$.data):Ie("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):se?Re&&t.texSubImage2D(n.TEXTURE_2D,ie,0,0,$.width,$.height,ae,N,$.data):t.texImage2D(n.TEXTURE_2D,ie,J,$.width,$.height,0,ae,N,$.data)}else if(S.isDataArrayTexture)if(se){if(oe&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Xe,J,K.width,K.height,K.depth),Re)if(S.layerUpdates.size>0){let ie=zd(K.width,K.height,S.format,S.type);for(let Ce of S.layerUpdates){let We=K.data.subarray(Ce*ie/K.data.BYTES_PER_ELEMENT,(Ce+1)*ie/K.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Ce,K.width,K.height,1,ae,N,We)}S.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,K.width,K.height,K.depth,ae,N,K.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,J,K.width,K.height,K.depth,0,ae,N,K.data);else if(S.isData3DTexture)se?(oe&&t.texStorage3D(n.TEXTURE_3D,Xe,J,K.width,K.height,K.depth),Re&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,K.width,K.height,K.depth,ae,N,K.data)):t.texImage3D(n.TEXTURE_3D,0,J,K.width,K.height,K.depth,0,ae,N,K.data);else if(S.isFramebufferTexture){if(oe)if(se)t.texStorage2D(n.TEXTURE_2D,Xe,J,K.width,K.height);else{let ie=K.width,Ce=K.height;for(let We=0;We<Xe;We++)t.texImage2D(n.TEXTURE_2D,We,J,ie,Ce,0,ae,N,null),ie>>=1,Ce>>=1}}else if(S.isHTMLTexture){if("texElementImage2D"in n){let ie=n.canvas;if(ie.hasAttribute("layoutsubtree")||ie.setAttribute("layoutsubtree","true"),K.parentNode!==ie){ie.appendChild(K),h.add(S),ie.onpaint=Ce=>{let We=Ce.changedElements;for(let ge of h)We.includes(ge.image)&&(ge.needsUpdate=!0)},ie.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,K);else{let We=n.RGBA,ge=n.RGBA,ct=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,We,ge,ct,K)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(le.length>0){if(se&&oe){let ie=Be(le[0]);t.texStorage2D(n.TEXTURE_2D,Xe,J,ie.width,ie.height)}for(let ie=0,Ce=le.length;ie<Ce;ie++)$=le[ie],se?Re&&t.texSubImage2D(n.TEXTURE_2D,ie,0,0,ae,N,$):t.texImage2D(n.TEXTURE_2D,ie,J,ae,N,$);S.generateMipmaps=!1}else if(se){if(oe){let ie=Be(K);t.texStorage2D(n.TEXTURE_2D,Xe,J,ie.width,ie.height)}Re&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,ae,N,K)}else t.texImage2D(n.TEXTURE_2D,0,J,ae,N,K);v(S)&&S.mipmapsAutoUpdate===!0&&M(ne),ue.__version=re.version,S.onUpdate&&S.onUpdate(S)}R.__version=S.version}function In(R,S,z){if(S.image.length!==6)return;let ne=ft(R,S),Q=S.source;t.bindTexture(n.TEXTURE_CUBE_MAP,R.__webglTexture,n.TEXTURE0+z);let re=i.get(Q);if(Q.version!==re.__version||ne===!0){t.activeTexture(n.TEXTURE0+z);let ue=Je.getPrimaries(Je.workingColorSpace),Z=S.colorSpace===es?null:Je.getPrimaries(S.colorSpace),K=S.colorSpace===es||ue===Z?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,S.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,K);let ae=S.isCompressedTexture||S.image[0].isCompressedTexture,N=S.image[0]&&S.image[0].isDataTexture,J=[];for(let ge=0;ge<6;ge++)!ae&&!N?J[ge]=y(S.image[ge],!0,s.maxCubemapSize):J[ge]=N?S.image[ge].image:S.image[ge],J[ge]=Ne(S,J[ge]);let $=J[0],le=r.convert(S.format,S.colorSpace),se=r.convert(S.type),oe=E(S.internalFormat,le,se,S.normalized,S.colorSpace),Re=S.isVideoTexture!==!0,Xe=re.__version===void 0||ne===!0,ie=Q.dataReady,Ce=b(S,$);lt(n.TEXTURE_CUBE_MAP,S);let We;if(S.isDepthTexture){if(oe=_(S.format===Qi,S.type),Xe)if(Re)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,oe,$.width,$.height);else for(let ge=0;ge<6;ge++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,oe,$.width,$.height,0,le,se,null)}else if(ae){Re&&Xe&&t.texStorage2D(n.TEXTURE_CUBE_MAP,Ce,oe,$.width,$.height);for(let ge=0;ge<6;ge++){We=J[ge].mipmaps;for(let ct=0;ct<We.length;ct++){let Ht=We[ct];S.format!==gi?le!==null?Re?ie&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ge,ct,0,0,Ht.width,Ht.height,le,Ht.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ge,ct,oe,Ht.width,Ht.height,0,Ht.data):Ie("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Re?ie&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ge,ct,0,0,Ht.width,Ht.height,le,se,Ht.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ge,ct,oe,Ht.width,Ht.height,0,le,se,Ht.data)}}}else{if(We=S.mipmaps,Re&&Xe){We.length>0&&Ce++;let ge=Be(J[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,Ce,oe,ge.width,ge.height)}for(let ge=0;ge<6;ge++)if(N){Re?ie&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,0,0,J[ge].width,J[ge].height,le,se,J[ge].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,oe,J[ge].width,J[ge].height,0,le,se,J[ge].data);for(let ct=0;ct<We.length;ct++){let ds=We[ct].image[ge].image;Re?ie&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ge,ct+1,0,0,ds.width,ds.height,le,se,ds.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ge,ct+1,oe,ds.width,ds.height,0,le,se,ds.data)}}else{Re?ie&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,0,0,le,se,J[ge]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,oe,le,se,J[ge]);for(let ct=0;ct<We.length;ct++){let Ht=We[ct];Re?ie&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ge,ct+1,0,0,le,se,Ht.image[ge]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ge,ct+1,oe,le,se,Ht.image[ge])}}}v(S)&&S.mipmapsAutoUpdate===!0&&M(n.TEXTURE_CUBE_MAP),re.__version=Q.version,S.onUpdate&&S.onUpdate(S)}R.__version=S.version}function Et(R,S,z,ne,Q,re){let ue=r.convert(z.format,z.colorSpace),Z=r.convert(z.type),K=E(z.internalFormat,ue,Z,z.normalized,z.colorSpace),ae=i.get(S),N=i.get(z);if(N.__renderTarget=S,!ae.__hasExternalTextures){let J=Math.max(1,S.width>>re),$=Math.max(1,S.height>>re);Q===n.TEXTURE_3D||Q===n.TEXTURE_2D_ARRAY?t.texImage3D(Q,re,K,J,$,S.depth,0,ue,Z,null):t.texImage2D(Q,re,K,J,$,0,ue,Z,null)}t.bindFramebuffer(n.FRAMEBUFFER,R),pe(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ne,Q,N.__webglTexture,0,St(S)):(Q===n.TEXTURE_2D||Q>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&Q<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ne,Q,N.__webglTexture,re),t.bindFramebuffer(n.FRAMEBUFFER,null)}function bi(R,S,z){if(n.bindRenderbuffer(n.RENDERBUFFER,R),S.depthBuffer){let ne=S.depthTexture,Q=ne&&ne.isDepthTexture?ne.type:null,re=_(S.stencilBuffer,Q),ue=S.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;pe(S)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,St(S),re,S.width,S.height):z?n.renderbufferStorageMultisample(n.RENDERBUFFER,St(S),re,S.width,S.height):n.renderbufferStorage(n.RENDERBUFFER,re,S.width,S.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,ue,n.RENDERBUFFER,R)}else{let ne=S.textures;for(let Q=0;Q<ne.length;Q++){let re=ne[Q],ue=r.convert(re.format,re.colorSpace),Z=r.convert(re.type),K=E(re.internalFormat,ue,Z,re.normalized,re.colorSpace);pe(S)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,St(S),K,S.width,S.height):z?n.renderbufferStorageMultisample(n.RENDERBUFFER,St(S),K,S.width,S.height):n.renderbufferStorage(n.RENDERBUFFER,K,S.width,S.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Vt(R,S,z){let ne=S.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,R),!(S.depthTexture&&S.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let Q=i.get(S.depthTexture);Q.__renderTarget=S;let re=ne?S.depthTexture.image[0]:S.depthTexture.image;(!Q.__webglTexture||re.width!==S.width||re.height!==S.height)&&(re.width=S.width,re.height=S.height,S.depthTexture.needsUpdate=!0),ne?ye(S.depthTexture,0):me(S.depthTexture,0);let ue=Q.__webglTexture,Z=St(S),K=ne?n.TEXTURE_CUBE_MAP_POSITIVE_X+z:n.TEXTURE_2D,ae=S.depthTexture.format===Qi?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(S.depthTexture.format===Zi)pe(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ae,K,ue,0,Z):n.framebufferTexture2D(n.FRAMEBUFFER,ae,K,ue,0);else if(S.depthTexture.format===Qi)pe(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ae,K,ue,0,Z):n.framebufferTexture2D(n.FRAMEBUFFER,ae,K,ue,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Yn(R){let S=i.get(R),z=R.isWebGLCubeRenderTarget===!0;if(S.__boundDepthTexture!==R.depthTexture){let ne=R.depthTexture;if(S.__depthDisposeCallback&&S.__depthDisposeCallback(),ne){let Q=()=>{delete S.__boundDepthTexture,delete S.__depthDisposeCallback,ne.removeEventListener("dispose",Q)};ne.addEventListener("dispose",Q),S.__depthDisposeCallback=Q}S.__boundDepthTexture=ne}if(R.depthTexture&&!S.__autoAllocateDepthBuffer)if(z)for(let ne=0;ne<6;ne++)Vt(S.__webglFramebuffer[ne],R,ne);else R.texture.mipmaps.length>0?Vt(S.__webglFramebuffer[0],R,0):Vt(S.__webglFramebuffer,R,0);else if(z){S.__webglDepthbuffer=[];for(let ne=0;ne<6;ne++)if(t.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer[ne]),S.__webglDepthbuffer[ne]===void 0)S.__webglDepthbuffer[ne]=n.createRenderbuffer(),bi(S.__webglDepthbuffer[ne],R,!1);else{let Q=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,re=S.__webglDepthbuffer[ne];n.bindRenderbuffer(n.RENDERBUFFER,re),n.framebufferRenderbuffer(n.FRAMEBUFFER,Q,n.RENDERBUFFER,re)}}else if(R.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer),S.__webglDepthbuffer===void 0)S.__webglDepthbuffer=n.createRenderbuffer(),bi(S.__webglDepthbuffer,R,!1);else{let Q=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,re=S.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,re),n.framebufferRenderbuffer(n.FRAMEBUFFER,Q,n.RENDERBUFFER,re)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function Zn(R,S,z){let ne=i.get(R);S!==void 0&&Et(ne.__webglFramebuffer,R,R.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),z!==void 0&&Yn(R)}function jn(R){let S=R.texture,z=i.get(R),ne=i.get(S);R.addEventListener("dispose",D),I(R);let Q=R.textures,re=R.isWebGLCubeRenderTarget===!0,ue=Q.length>1;if(ue||(ne.__webglTexture===void 0&&(ne.__webglTexture=n.createTexture()),ne.__version=S.version,o.memory.textures++),re){z.__webglFramebuffer=[];for(let Z=0;Z<6;Z++)if(S.mipmaps.length>0){z.__webglFramebuffer[Z]=[];for(let K=0;K<S.mipmaps.length;K++)z.__webglFramebuffer[Z][K]=n.createFramebuffer()}else z.__webglFramebuffer[Z]=n.createFramebuffer()}else{if(S.mipmaps.length>0){z.__webglFramebuffer=[];for(let Z=0;Z<S.mipmaps.length;Z++)z.__webglFramebuffer[Z]=n.createFramebuffer()}else z.__webglFramebuffer=n.createFramebuffer();if(ue)for(let Z=0,K=Q.length;Z<K;Z++){let ae=i.get(Q[Z]);ae.__webglTexture===void 0&&(ae.__webglTexture=n.createTexture(),o.memory.textures++)}if(R.samples>0&&pe(R)===!1){z.__webglMultisampledFramebuffer=n.createFramebuffer(),z.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,z.__webglMultisampledFramebuffer);for(let Z=0;Z<Q.length;Z++){let K=Q[Z];z.__webglColorRenderbuffer[Z]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,z.__webglColorRenderbuffer[Z]);let ae=r.convert(K.format,K.colorSpace),N=r.convert(K.type),J=E(K.internalFormat,ae,N,K.normalized,K.colorSpace,R.isXRRenderTarget===!0),$=St(R);n.renderbufferStorageMultisample(n.RENDERBUFFER,$,J,R.width,R.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+Z,n.RENDERBUFFER,z.__webglColorRenderbuffer[Z])}n.bindRenderbuffer(n.RENDERBUFFER,null),R.depthBuffer&&(z.__webglDepthRenderbuffer=n.createRenderbuffer(),bi(z.__webglDepthRenderbuffer,R,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(re){t.bindTexture(n.TEXTURE_CUBE_MAP,ne.__webglTexture),lt(n.TEXTURE_CUBE_MAP,S);for(let Z=0;Z<6;Z++)if(S.mipmaps.length>0)for(let K=0;K<S.mipmaps.length;K++)Et(z.__webglFramebuffer[Z][K],R,S,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+Z,K);else Et(z.__webglFramebuffer[Z],R,S,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+Z,0);v(S)?M(n.TEXTURE_CUBE_MAP):S.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}else if(ue){for(let Z=0,K=Q.length;Z<K;Z++){let ae=Q[Z],N=i.get(ae),J=n.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(J=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(J,N.__webglTexture),lt(J,ae),Et(z.__webglFramebuffer,R,ae,n.COLOR_ATTACHMENT0+Z,J,0),v(ae)&&M(J)}t.unbindTexture()}else{let Z=n.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(Z=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(Z,ne.__webglTexture),lt(Z,S),S.mipmaps.length>0)for(let K=0;K<S.mipmaps.length;K++)Et(z.__webglFramebuffer[K],R,S,n.COLOR_ATTACHMENT0,Z,K);else Et(z.__webglFramebuffer,R,S,n.COLOR_ATTACHMENT0,Z,0);v(S)?M(Z):S.mipmaps.length>0&&n.texParameteri(Z,n.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}R.depthBuffer&&Yn(R)}function F(R){let S=R.textures;for(let z=0,ne=S.length;z<ne;z++){let Q=S[z];if(v(Q)&&Q.mipmapsAutoUpdate===!0){let re=w(R),ue=i.get(Q).__webglTexture;t.bindTexture(re,ue),M(re),t.unbindTexture()}}}let Kn=[];function bt(R){if(R.samples>0){if(pe(R)===!1){let S=R.textures,z=R.width,ne=R.height,Q=n.COLOR_BUFFER_BIT,re=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ue=i.get(R),Z=S.length>1;if(Z)for(let ae=0;ae<S.length;ae++)t.bindFramebuffer(n.FRAMEBUFFER,ue.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ae,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,ue.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+ae,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,ue.__webglMultisampledFramebuffer),R.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ue.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ue.__webglFramebuffer);for(let ae=0;ae<S.length;ae++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(Q|=n.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(Q|=n.STENCIL_BUFFER_BIT)),Z){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,ue.__webglColorRenderbuffer[ae]);let N=i.get(S[ae]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,N,0)}n.blitFramebuffer(0,0,z,ne,0,0,z,ne,Q,n.NEAREST),l===!0&&(Kn.length=0,Kn.push(n.COLOR_ATTACHMENT0+ae),R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&Kn.push(re),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Kn))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),Z)for(let ae=0;ae<S.length;ae++){t.bindFramebuffer(n.FRAMEBUFFER,ue.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ae,n.RENDERBUFFER,ue.__webglColorRenderbuffer[ae]);let N=i.get(S[ae]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,ue.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+ae,n.TEXTURE_2D,N,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ue.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&l){let S=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[S])}}}function St(R){return Math.min(s.maxSamples,R.samples)}function pe(R){let S=i.get(R);return R.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&S.__useRenderToTexture!==!1}function Ut(R){let S=o.render.frame;u.get(R)!==S&&(u.set(R,S),R.update())}function Ne(R,S){let z=R.colorSpace,ne=R.format,Q=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||z!==Go&&z!==es&&(Je.getTransfer(z)===st?(ne!==gi||Q!==Dn)&&Ie("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Ue("WebGLTextures: Unsupported texture color space:",z)),S}function Be(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(c.width=R.naturalWidth||R.width,c.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(c.width=R.displayWidth,c.height=R.displayHeight):(c.width=R.width,c.height=R.height),c}this.allocateTextureUnit=Pe,this.resetTextureUnits=j,this.getTextureUnits=te,this.setTextureUnits=ve,this.setTexture2D=me,this.setTexture2DArray=Me,this.setTexture3D=Le,this.setTextureCube=ye,this.rebindTextures=Zn,this.setupRenderTarget=jn,this.updateRenderTargetMipmap=F,this.updateMultisampleRenderTarget=bt,this.setupDepthRenderbuffer=Yn,this.setupFrameBufferTexture=Et,this.useMultisampledRTT=pe,this.dispose=O}function jw(n,e){function t(i,s=es){let r,o=Je.getTransfer(s);if(i===Dn)return n.UNSIGNED_BYTE;if(i===vc)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Mc)return n.UNSIGNED_SHORT_5_5_5_1;if(i===wd)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Ad)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===bd)return n.BYTE;if(i===Sd)return n.SHORT;if(i===Jr)return n.UNSIGNED_SHORT;if(i===_c)return n.INT;if(i===pi)return n.UNSIGNED_INT;if(i===ii)return n.FLOAT;if(i===mi)return n.HALF_FLOAT;if(i===Ed)return n.ALPHA;if(i===Td)return n.RGB;if(i===gi)return n.RGBA;if(i===Zi)return n.DEPTH_COMPONENT;if(i===Qi)return n.DEPTH_STENCIL;if(i===bc)return n.RED;if(i===Sc)return n.RED_INTEGER;if(i===Rs)return n.RG;if(i===wc)return n.RG_INTEGER;if(i===Ac)return n.RGBA_INTEGER;if(i===ya||i===_a||i===va||i===Ma)if(o===st)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===ya)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===_a)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===va)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Ma)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===ya)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===_a)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===va)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Ma)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Ec||i===Tc||i===Rc||i===Cc)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Ec)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Tc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Rc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Cc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Ic||i===Pc||i===Lc||i===Nc||i===Dc||i===ba||i===Uc)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Ic||i===Pc)return o===st?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Lc)return o===st?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===Nc)return r.COMPRESSED_R11_EAC;if(i===Dc)return r.COMPRESSED_SIGNED_R11_EAC;if(i===ba)return r.COMPRESSED_RG11_EAC;if(i===Uc)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Fc||i===Oc||i===Bc||i===kc||i===zc||i===Gc||i===Vc||i===Hc||i===Wc||i===qc||i===Xc||i===$c||i===Yc||i===Zc)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Fc)return o===st?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Oc)return o===st?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Bc)return o===st?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===kc)return o===st?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===zc)return o===st?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Gc)return o===st?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Vc)return o===st?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Hc)return o===st?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Wc)return o===st?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===qc)return o===st?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Xc)return o===st?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===$c)return o===st?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Yc)return o===st?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Zc)return o===st?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===jc||i===Kc||i===Jc)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===jc)return o===st?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Kc)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Jc)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Qc||i===eu||i===Sa||i===tu)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===Qc)return r.COMPRESSED_RED_RGTC1_EXT;if(i===eu)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Sa)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===tu)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===ar?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var Kw=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,Jw=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Zd=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new ta(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new ni({vertexShader:Kw,fragmentShader:Jw,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Ye(new ir(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},jd=class extends Ai{constructor(e,t){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,d=null,f=null,p=null,x=typeof XRWebGLBinding<"u",m=new Zd,g={},y=t.getContextAttributes(),v=null,M=null,w=[],E=[],_=new Ge,b=null,I=null,T=new yn;T.viewport=new ot;let L=new yn;L.viewport=new ot;let D=[T,L],B=new mc,P=null,O=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Y){let me=w[Y];return me===void 0&&(me=new Vr,w[Y]=me),me.getTargetRaySpace()},this.getControllerGrip=function(Y){let me=w[Y];return me===void 0&&(me=new Vr,w[Y]=me),me.getGripSpace()},this.getHand=function(Y){let me=w[Y];return me===void 0&&(me=new Vr,w[Y]=me),me.getHandSpace()};function H(Y){let me=E.indexOf(Y.inputSource);if(me===-1)return;let Me=w[me];Me!==void 0&&(Me.update(Y.inputSource,Y.frame,c||o),Me.dispatchEvent({type:Y.type,data:Y.inputSource}))}function V(){s.removeEventListener("select",H),s.removeEventListener("selectstart",H),s.removeEventListener("selectend",H),s.removeEventListener("squeeze",H),s.removeEventListener("squeezestart",H),s.removeEventListener("squeezeend",H),s.removeEventListener("end",V),s.removeEventListener("inputsourceschange",ee);for(let Y=0;Y<w.length;Y++){let me=E[Y];me!==null&&(E[Y]=null,w[Y].disconnect(me))}P=null,O=null,m.reset();for(let Y in g)delete g[Y];if(e.setRenderTarget(v),f=null,d=null,h=null,s=null,M=null,Pe.stop(),i.isPresenting=!1,e.setPixelRatio(b),e.setSize(_.width,_.height,!1),I!==null){let Y=I.camera;Y.fov=I.fov,Y.zoom=I.zoom,Y.updateProjectionMatrix(),I=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Y){r=Y,i.isPresenting===!0&&Ie("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Y){a=Y,i.isPresenting===!0&&Ie("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(Y){c=Y},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return h===null&&x&&(h=new XRWebGLBinding(s,t)),h},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(Y){if(s=Y,s!==null){if(v=e.getRenderTarget(),s.addEventListener("select",H),s.addEventListener("selectstart",H),s.addEventListener("selectend",H),s.addEventListener("squeeze",H),s.addEventListener("squeezestart",H),s.addEventListener("squeezeend",H),s.addEventListener("end",V),s.addEventListener("inputsourceschange",ee),y.xrCompatible!==!0&&await t.makeXRCompatible(),b=e.getPixelRatio(),e.getSize(_),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let Me=null,Le=null,ye=null;y.depth&&(ye=y.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,Me=y.stencil?Qi:Zi,Le=y.stencil?ar:pi);let ze={colorFormat:t.RGBA8,depthFormat:ye,scaleFactor:r};h=this.getBinding(),d=h.createProjectionLayer(ze),s.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),M=new kn(d.textureWidth,d.textureHeight,{format:gi,type:Dn,depthTexture:new ji(d.textureWidth,d.textureHeight,Le,void 0,void 0,void 0,void 0,void 0,void 0,Me),stencilBuffer:y.stencil,colorSpace:e.outputColorSpace,samples:y.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let Me={antialias:y.antialias,alpha:!0,depth:y.depth,stencil:y.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,Me),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),M=new kn(f.framebufferWidth,f.framebufferHeight,{format:gi,type:Dn,colorSpace:e.outputColorSpace,stencilBuffer:y.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}M.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),Pe.setContext(s),Pe.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function ee(Y){for(let me=0;me<Y.removed.length;me++){let Me=Y.removed[me],Le=E.indexOf(Me);Le>=0&&(E[Le]=null,w[Le].disconnect(Me))}for(let me=0;me<Y.added.length;me++){let Me=Y.added[me],Le=E.indexOf(Me);if(Le===-1){for(let ze=0;ze<w.length;ze++)if(ze>=E.length){E.push(Me),Le=ze;break}else if(E[ze]===null){E[ze]=Me,Le=ze;break}if(Le===-1)break}let ye=w[Le];ye&&ye.connect(Me)}}function X(Y,me){me===null?Y.matrixWorld.copy(Y.matrix):Y.matrixWorld.multiplyMatrices(me.matrixWorld,Y.matrix),Y.matrixWorldInverse.copy(Y.matrixWorld).invert()}this.updateCamera=function(Y){if(s===null)return;let me=Y.near,Me=Y.far;m.texture!==null&&(m.depthNear>0&&(me=m.depthNear),m.depthFar>0&&(Me=m.depthFar)),B.near=L.near=T.near=me,B.far=L.far=T.far=Me,(P!==B.near||O!==B.far)&&(s.updateRenderState({depthNear:B.near,depthFar:B.far}),P=B.near,O=B.far),B.layers.mask=Y.layers.mask|6,T.layers.mask=B.layers.mask&-5,L.layers.mask=B.layers.mask&-3;let Le=Y.parent,ye=B.cameras;X(B,Le);for(let ze=0;ze<ye.length;ze++)X(ye[ze],Le);B.projectionMatrix.copy(T.projectionMatrix),B.projectionMatrixInverse.copy(T.projectionMatrixInverse),I===null&&Y.isPerspectiveCamera&&(I={camera:Y,fov:Y.fov,zoom:Y.zoom}),j(Y,B,Le)};function j(Y,me,Me){Me===null?Y.matrix.copy(me.matrixWorld):(Y.matrix.copy(Me.matrixWorld),Y.matrix.invert(),Y.matrix.multiply(me.matrixWorld)),Y.matrix.decompose(Y.position,Y.quaternion,Y.scale),Y.updateMatrixWorld(!0),Y.projectionMatrix.copy(me.projectionMatrix),Y.projectionMatrixInverse.copy(me.projectionMatrixInverse),Y.isPerspectiveCamera&&(Y.fov=zr*2*Math.atan(1/Y.projectionMatrix.elements[5]),Y.zoom=1)}this.getCamera=function(){return B},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(Y){l=Y,d!==null&&(d.fixedFoveation=Y),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=Y)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(B)},this.getCameraTexture=function(Y){return g[Y]};let te=null;function ve(Y,me){if(u=me.getViewerPose(c||o),p=me,u!==null){let Me=u.views;f!==null&&(e.setRenderTargetFramebuffer(M,f.framebuffer),e.setRenderTarget(M));let Le=!1;Me.length!==B.cameras.length&&(B.cameras.length=0,Le=!0);for(let De=0;De<Me.length;De++){let lt=Me[De],ft=null;if(f!==null)ft=f.getViewport(lt);else{let Qt=h.getViewSubImage(d,lt);ft=Qt.viewport,De===0&&(e.setRenderTargetTextures(M,Qt.colorTexture,Qt.depthStencilTexture),e.setRenderTarget(M))}let Ze=D[De];Ze===void 0&&(Ze=new yn,Ze.layers.enable(De),Ze.viewport=new ot,D[De]=Ze),Ze.matrix.fromArray(lt.transform.matrix),Ze.matrix.decompose(Ze.position,Ze.quaternion,Ze.scale),Ze.projectionMatrix.fromArray(lt.projectionMatrix),Ze.projectionMatrixInverse.copy(Ze.projectionMatrix).invert(),Ze.viewport.set(ft.x,ft.y,ft.width,ft.height),De===0&&(B.matrix.copy(Ze.matrix),B.matrix.decompose(B.position,B.quaternion,B.scale)),Le===!0&&B.cameras.push(Ze)}let ye=s.enabledFeatures;if(ye&&ye.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&x){h=i.getBinding();let De=h.getDepthInformation(Me[0]);De&&De.isValid&&De.texture&&m.init(De,s.renderState)}if(ye&&ye.includes("camera-access")&&x){e.state.unbindTexture(),h=i.getBinding();for(let De=0;De<Me.length;De++){let lt=Me[De].camera;if(lt){let ft=g[lt];ft||(ft=new ta,g[lt]=ft);let Ze=h.getCameraImage(lt);ft.sourceTexture=Ze}}}}for(let Me=0;Me<w.length;Me++){let Le=E[Me],ye=w[Me];Le!==null&&ye!==void 0&&ye.update(Le,me,c||o)}te&&te(Y,me),me.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:me}),p=null}let Pe=new Rg;Pe.setAnimationLoop(ve),this.setAnimationLoop=function(Y){te=Y},this.dispose=function(){}}},Qw=new Qe,Bg=new Oe;Bg.set(-1,0,0,0,1,0,0,0,1);function eA(n,e){function t(m,g){m.matrixAutoUpdate===!0&&m.updateMatrix(),g.value.copy(m.matrix)}function i(m,g){g.color.getRGB(m.fogColor.value,Od(n)),g.isFog?(m.fogNear.value=g.near,m.fogFar.value=g.far):g.isFogExp2&&(m.fogDensity.value=g.density)}function s(m,g,y,v,M){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(m,g):g.isMeshLambertMaterial?(r(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(m,g),h(m,g)):g.isMeshPhongMaterial?(r(m,g),u(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(m,g),d(m,g),g.isMeshPhysicalMaterial&&f(m,g,M)):g.isMeshMatcapMaterial?(r(m,g),p(m,g)):g.isMeshDepthMaterial?r(m,g):g.isMeshDistanceMaterial?(r(m,g),x(m,g)):g.isMeshNormalMaterial?r(m,g):g.isLineBasicMaterial?(o(m,g),g.isLineDashedMaterial&&a(m,g)):g.isPointsMaterial?l(m,g,y,v):g.isSpriteMaterial?c(m,g):g.isShadowMaterial?(m.color.value.copy(g.color),m.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(m,g){m.opacity.value=g.opacity,g.color&&m.diffuse.value.copy(g.color),g.emissive&&m.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(m.map.value=g.map,t(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.bumpMap&&(m.bumpMap.value=g.bumpMap,t(g.bumpMap,m.bumpMapTransform),m.bumpScale.value=g.bumpScale,g.side===Mn&&(m.bumpScale.value*=-1)),g.normalMap&&(m.normalMap.value=g.normalMap,t(g.normalMap,m.normalMapTransform),m.normalScale.value.copy(g.normalScale),g.side===Mn&&m.normalScale.value.negate()),g.displacementMap&&(m.displacementMap.value=g.displacementMap,t(g.displacementMap,m.displacementMapTransform),m.displacementScale.value=g.displacementScale,m.displacementBias.value=g.displacementBias),g.emissiveMap&&(m.emissiveMap.value=g.emissiveMap,t(g.emissiveMap,m.emissiveMapTransform)),g.specularMap&&(m.specularMap.value=g.specularMap,t(g.specularMap,m.specularMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest);let y=e.get(g),v=y.envMap,M=y.envMapRotation;v&&(m.envMap.value=v,m.envMapRotation.value.setFromMatrix4(Qw.makeRotationFromEuler(M)).transpose(),v.isCubeTexture&&v.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(Bg),m.reflectivity.value=g.reflectivity,m.ior.value=g.ior,m.refractionRatio.value=g.refractionRatio),g.lightMap&&(m.lightMap.value=g.lightMap,m.lightMapIntensity.value=g.lightMapIntensity,t(g.lightMap,m.lightMapTransform)),g.aoMap&&(m.aoMap.value=g.aoMap,m.aoMapIntensity.value=g.aoMapIntensity,t(g.aoMap,m.aoMapTransform))}function o(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,g.map&&(m.map.value=g.map,t(g.map,m.mapTransform))}function a(m,g){m.dashSize.value=g.dashSize,m.totalSize.value=g.dashSize+g.gapSize,m.scale.value=g.scale}function l(m,g,y,v){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.size.value=g.size*y,m.scale.value=v*.5,g.map&&(m.map.value=g.map,t(g.map,m.uvTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function c(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.rotation.value=g.rotation,g.map&&(m.map.value=g.map,t(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function u(m,g){m.specular.value.copy(g.specular),m.shininess.value=Math.max(g.shininess,1e-4)}function h(m,g){g.gradientMap&&(m.gradientMap.value=g.gradientMap)}function d(m,g){m.metalness.value=g.metalness,g.metalnessMap&&(m.metalnessMap.value=g.metalnessMap,t(g.metalnessMap,m.metalnessMapTransform)),m.roughness.value=g.roughness,g.roughnessMap&&(m.roughnessMap.value=g.roughnessMap,t(g.roughnessMap,m.roughnessMapTransform)),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)}function f(m,g,y){m.ior.value=g.ior,g.diffuseRoughness>0&&(m.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=g.diffuseRoughnessMap,t(g.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),g.sheen>0&&(m.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),m.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(m.sheenColorMap.value=g.sheenColorMap,t(g.sheenColorMap,m.sheenColorMapTransform)),g.sheenRoughnessMap&&(m.sheenRoughnessMap.value=g.sheenRoughnessMap,t(g.sheenRoughnessMap,m.sheenRoughnessMapTransform))),g.clearcoat>0&&(m.clearcoat.value=g.clearcoat,m.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(m.clearcoatMap.value=g.clearcoatMap,t(g.clearcoatMap,m.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,t(g.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(m.clearcoatNormalMap.value=g.clearcoatNormalMap,t(g.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===Mn&&m.clearcoatNormalScale.value.negate())),g.dispersion>0&&(m.dispersion.value=g.dispersion),g.retroreflectivity>0&&(m.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(m.iridescence.value=g.iridescence,m.iridescenceIOR.value=g.iridescenceIOR,m.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(m.iridescenceMap.value=g.iridescenceMap,t(g.iridescenceMap,m.iridescenceMapTransform)),g.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=g.iridescenceThicknessMap,t(g.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),g.transmission>0&&(m.transmission.value=g.transmission,m.transmissionSamplerMap.value=y.texture,m.transmissionSamplerSize.value.set(y.width,y.height),g.transmissionMap&&(m.transmissionMap.value=g.transmissionMap,t(g.transmissionMap,m.transmissionMapTransform)),m.thickness.value=g.thickness,g.thicknessMap&&(m.thicknessMap.value=g.thicknessMap,t(g.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=g.attenuationDistance,m.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(m.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(m.anisotropyMap.value=g.anisotropyMap,t(g.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=g.specularIntensity,m.specularColor.value.copy(g.specularColor),g.specularColorMap&&(m.specularColorMap.value=g.specularColorMap,t(g.specularColorMap,m.specularColorMapTransform)),g.specularIntensityMap&&(m.specularIntensityMap.value=g.specularIntensityMap,t(g.specularIntensityMap,m.specularIntensityMapTransform))}function p(m,g){g.matcap&&(m.matcap.value=g.matcap)}function x(m,g){let y=e.get(g).light;m.referencePosition.value.setFromMatrixPosition(y.matrixWorld),m.nearDistance.value=y.shadow.camera.near,m.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function tA(n,e,t,i){let s={},r={};function o(y,v){let M=v.program;i.uniformBlockBinding(y,M,s[y.id])}function a(y,v){let M=s[y.id];M===void 0&&(p(y),M=l(y),s[y.id]=M,y.addEventListener("dispose",m));let w=v.program;i.updateUBOMapping(y,w);let E=e.render.frame;r[y.id]!==E&&(c(y),r[y.id]=E)}function l(y){let v=n.createBuffer(),M=y.__size,w=y.usage;return n.bindBuffer(n.UNIFORM_BUFFER,v),n.bufferData(n.UNIFORM_BUFFER,M,w),n.bindBuffer(n.UNIFORM_BUFFER,null),v}function c(y){let v=s[y.id],M=y.uniforms,w=y.__cache;n.bindBuffer(n.UNIFORM_BUFFER,v);for(let E=0,_=M.length;E<_;E++){let b=M[E];if(Array.isArray(b))for(let I=0,T=b.length;I<T;I++)u(b[I],E,I,w);else u(b,E,0,w)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(y,v,M,w){if(d(y,v,M,w)===!0){let E=y.__offset,_=y.value;if(Array.isArray(_)){let b=0;for(let I=0;I<_.length;I++){let T=_[I],L=x(T,!0);h(T,y.__data,b),b+=L.storage/Float32Array.BYTES_PER_ELEMENT}}else h(_,y.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,E,y.__data)}}function h(y,v,M){typeof y=="number"||typeof y=="boolean"?v[M]=y:y.isMatrix3?(v[M]=y.elements[0],v[M+1]=y.elements[1],v[M+2]=y.elements[2],v[M+3]=0,v[M+4]=y.elements[3],v[M+5]=y.elements[4],v[M+6]=y.elements[5],v[M+7]=0,v[M+8]=y.elements[6],v[M+9]=y.elements[7],v[M+10]=y.elements[8],v[M+11]=0):ArrayBuffer.isView(y)?v.set(y.subarray(0,v.length-M),M):y.toArray(v,M)}function d(y,v,M,w){let E=y.value,_=v+"_"+M;if(Array.isArray(E)){w[_]===void 0&&(w[_]=[]);let b=w[_],I=!1;for(let T=0;T<E.length;T++)f(E[T],b,T)===!0&&(I=!0);return I}return f(E,w,_)}function f(y,v,M){if(v[M]===void 0)return typeof y=="number"||typeof y=="boolean"?v[M]=y:ArrayBuffer.isView(y)?v[M]=y.slice():v[M]=y.clone(),!0;{let w=v[M];if(typeof y=="number"||typeof y=="boolean"){if(w!==y)return v[M]=y,!0}else{if(ArrayBuffer.isView(y))return!0;if(w.equals(y)===!1)return w.copy(y),!0}}return!1}function p(y){let v=y.uniforms,M=0,w=16;for(let _=0,b=v.length;_<b;_++){let I=Array.isArray(v[_])?v[_]:[v[_]];for(let T=0,L=I.length;T<L;T++){let D=I[T],B=Array.isArray(D.value)?D.value:[D.value],P=Array.isArray(v[_])||Array.isArray(D.value),O=M;for(let V=0,ee=B.length;V<ee;V++){let X=B[V],j=x(X,P),te=M%w,ve=te%j.boundary,Pe=te+ve;M+=ve,Pe!==0&&w-Pe<j.storage&&(M+=w-Pe),V===0&&(O=M),M+=j.storage}let H=D.type==="int"?Int32Array:D.type==="uint"?Uint32Array:Float32Array;D.__data=new H((M-O)/Float32Array.BYTES_PER_ELEMENT),D.__offset=O}}let E=M%w;return E>0&&(M+=w-E),y.__size=M,y.__cache={},this}function x(y,v){let M={boundary:0,storage:0};return typeof y=="number"||typeof y=="boolean"?(M.boundary=4,M.storage=4):y.isVector2?(M.boundary=8,M.storage=8):y.isVector3||y.isColor?(M.boundary=16,M.storage=12):y.isVector4?(M.boundary=16,M.storage=16):y.isMatrix3?(M.boundary=16,M.storage=48):y.isMatrix4?(M.boundary=16,M.storage=64):y.isTexture?Ie("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(y)?(M.boundary=16,M.storage=y.byteLength):Ie("WebGLRenderer: Unsupported uniform value type.",y),v===!0&&(M.boundary=16,M.storage=Math.ceil(M.storage/16)*16),M}function m(y){let v=y.target;v.removeEventListener("dispose",m),n.deleteBuffer(s[v.id]),delete s[v.id],delete r[v.id]}function g(){for(let y in s)n.deleteBuffer(s[y]);s={},r={}}return{bind:o,update:a,dispose:g}}var nA=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Ci=null;function iA(){return Ci===null&&(Ci=new di(nA,16,16,Rs,mi),Ci.name="DFG_LUT",Ci.minFilter=Ft,Ci.magFilter=Ft,Ci.wrapS=wi,Ci.wrapT=wi,Ci.generateMipmaps=!1,Ci.needsUpdate=!0),Ci}var au=class{constructor(e={}){let{canvas:t=eg(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:d=!1,outputBufferType:f=Dn}=e;this.isWebGLRenderer=!0;let p;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=i.getContextAttributes().alpha}else p=o;let x=f,m=new Set([Ac,wc,Sc]),g=new Set([Dn,pi,Jr,ar,vc,Mc]),y=new Uint32Array(4),v=new Int32Array(4),M={textures:[],min:[],max:[],resolution:[]},w=null,E=null,_=[],b=[],I=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Ri,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let T=this,L=!1,D=null,B=null,P=null,O=null;this._outputColorSpace=Bn;let H=0,V=0,ee=null,X=-1,j=null,te=new ot,ve=new ot,Pe=null,Y=new Fe(0),me=0,Me=t.width,Le=t.height,ye=1,ze=null,Pt=null,De=new ot(0,0,Me,Le),lt=new ot(0,0,Me,Le),ft=!1,Ze=new vs,Qt=new Kl,Dt=!1,In=!1,Et=new Qe,bi=new C,Vt=new ot,Yn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Zn=!1;function jn(){return ee===null?ye:1}let F=i;function Kn(A,U){return t.getContext(A,U)}let bt,St,pe,Ut,Ne,Be,R,S,z,ne,Q,re,ue,Z,K,ae,N,J,$,le,se,oe,Re;try{let A={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Ce,!1),t.addEventListener("webglcontextrestored",We,!1),t.addEventListener("webglcontextcreationerror",ge,!1),F===null){let U="webgl2";if(F=Kn(U,A),F===null)throw Kn(U)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Xe()}catch(A){throw t.removeEventListener("webglcontextlost",Ce,!1),t.removeEventListener("webglcontextrestored",We,!1),t.removeEventListener("webglcontextcreationerror",ge,!1),Ue("WebGLRenderer: "+A.message),A}function Xe(){bt=new p1(F),bt.init(),se=new jw(F,bt),St=new i1(F,bt,e,se),pe=new Yw(F,bt),St.reversedDepthBuffer&&d&&pe.buffers.depth.setReversed(!0),B=F.createFramebuffer(),P=F.createFramebuffer(),O=F.createFramebuffer(),Ut=new x1(F),Ne=new Dw,Be=new Zw(F,bt,pe,Ne,St,se,Ut),R=new f1(T),S=new _M(F),oe=new t1(F,S),z=new m1(F,S,Ut,oe),ne=new _1(F,z,S,oe,Ut),J=new y1(F,St,Be),K=new s1(Ne),Q=new Nw(T,R,bt,St,oe,K),re=new eA(T,Ne),ue=new Fw,Z=new Vw(bt),N=new e1(T,R,pe,ne,p,l),ae=new $w(T,ne,St),Re=new tA(F,Ut,St,pe),$=new n1(F,bt,Ut),le=new g1(F,bt,Ut),Ut.programs=Q.programs,T.capabilities=St,T.extensions=bt,T.properties=Ne,T.renderLists=ue,T.shadowMap=ae,T.state=pe,T.info=Ut}x!==Dn&&(I=new M1(x,t.width,t.height,a,s,r));let ie=new jd(T,F);this.xr=ie,this.getContext=function(){return F},this.getContextAttributes=function(){return F.getContextAttributes()},this.forceContextLoss=function(){let A=bt.get("WEBGL_lose_context");A&&A.loseContext()},this.forceContextRestore=function(){let A=bt.get("WEBGL_lose_context");A&&A.restoreContext()},this.getPixelRatio=function(){return ye},this.setPixelRatio=function(A){A!==void 0&&(ye=A,this.setSize(Me,Le,!1))},this.getSize=function(A){return A.set(Me,Le)},this.setSize=function(A,U,q=!0){if(ie.isPresenting){Ie("WebGLRenderer: Can't change size while VR device is presenting.");return}Me=A,Le=U,t.width=Math.floor(A*ye),t.height=Math.floor(U*ye),q===!0&&(t.style.width=A+"px",t.style.height=U+"px"),I!==null&&I.setSize(t.width,t.height),this.setViewport(0,0,A,U)},this.getDrawingBufferSize=function(A){return A.set(Me*ye,Le*ye).floor()},this.setDrawingBufferSize=function(A,U,q){Me=A,Le=U,ye=q,t.width=Math.floor(A*q),t.height=Math.floor(U*q),this.setViewport(0,0,A,U)},this.setEffects=function(A){if(x===Dn){Ue("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(A){for(let U=0;U<A.length;U++)if(A[U].isOutputPass===!0){Ie("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}I.setEffects(A||[])},this.getCurrentViewport=function(A){return A.copy(te)},this.getViewport=function(A){return A.copy(De)},this.setViewport=function(A,U,q,k){A.isVector4?De.set(A.x,A.y,A.z,A.w):De.set(A,U,q,k),pe.viewport(te.copy(De).multiplyScalar(jn()).round())},this.getScissor=function(A){return A.copy(lt)},this.setScissor=function(A,U,q,k){A.isVector4?lt.set(A.x,A.y,A.z,A.w):lt.set(A,U,q,k),pe.scissor(ve.copy(lt).multiplyScalar(jn()).round())},this.getScissorTest=function(){return ft},this.setScissorTest=function(A){pe.setScissorTest(ft=A)},this.setOpaqueSort=function(A){ze=A},this.setTransparentSort=function(A){Pt=A},this.getClearColor=function(A){return A.copy(N.getClearColor())},this.setClearColor=function(){N.setClearColor(...arguments)},this.getClearAlpha=function(){return N.getClearAlpha()},this.setClearAlpha=function(){N.setClearAlpha(...arguments)},this.clear=function(A=!0,U=!0,q=!0){let k=0;if(A){let G=!1;if(ee!==null){let he=ee.texture.format;G=m.has(he)}if(G){let he=ee.texture.type,Se=g.has(he),ce=N.getClearColor(),_e=N.getClearAlpha(),Ee=ce.r,ke=ce.g,je=ce.b;Se?(y[0]=Ee,y[1]=ke,y[2]=je,y[3]=_e,F.clearBufferuiv(F.COLOR,0,y)):(v[0]=Ee,v[1]=ke,v[2]=je,v[3]=_e,F.clearBufferiv(F.COLOR,0,v))}else k|=F.COLOR_BUFFER_BIT}U&&(k|=F.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),q&&(k|=F.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),k!==0&&F.clear(k)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(A){A.setRenderer(this),D=A},this.dispose=function(){t.removeEventListener("webglcontextlost",Ce,!1),t.removeEventListener("webglcontextrestored",We,!1),t.removeEventListener("webglcontextcreationerror",ge,!1),N.dispose(),ue.dispose(),Z.dispose(),Be.dispose(),Ne.dispose(),R.dispose(),ne.dispose(),z.dispose(),oe.dispose(),Re.dispose(),Q.dispose(),ie.dispose(),ie.removeEventListener("sessionstart",Cp),ie.removeEventListener("sessionend",Ip),Zs.stop()};function Ce(A){A.preventDefault(),Wo("WebGLRenderer: Context Lost."),L=!0}function We(){Wo("WebGLRenderer: Context Restored."),L=!1;let A=Ut.autoReset,U=ae.enabled,q=ae.autoUpdate,k=ae.needsUpdate,G=ae.type;Xe(),Ut.autoReset=A,ae.enabled=U,ae.autoUpdate=q,ae.needsUpdate=k,ae.type=G}function ge(A){Ue("WebGLRenderer: A WebGL context could not be created. Reason: ",A.statusMessage)}function ct(A){let U=A.target;U.removeEventListener("dispose",ct),Ht(U)}function Ht(A){ds(A),Ne.remove(A)}function ds(A){let U=Ne.get(A).programs;U!==void 0&&(U.forEach(function(q){Q.releaseProgram(q)}),A.isShaderMaterial&&Q.releaseShaderCache(A))}this.renderBufferDirect=function(A,U,q,k,G,he){U===null&&(U=Yn);let Se=G.isMesh&&G.matrixWorld.determinantAffine()<0,ce=uv(A,U,q,k,G);pe.setMaterial(k,Se);let _e=q.index,Ee=1;if(k.wireframe===!0){if(_e=z.getWireframeAttribute(q),_e===void 0)return;Ee=2}let ke=q.drawRange,je=q.attributes.position,we=ke.start*Ee,Ke=(ke.start+ke.count)*Ee;he!==null&&(we=Math.max(we,he.start*Ee),Ke=Math.min(Ke,(he.start+he.count)*Ee)),_e!==null?(we=Math.max(we,0),Ke=Math.min(Ke,_e.count)):je!=null&&(we=Math.max(we,0),Ke=Math.min(Ke,je.count));let Lt=Ke-we;if(Lt<0||Lt===1/0)return;oe.setup(G,k,ce,q,_e);let gt,pt=$;if(_e!==null&&(gt=S.get(_e),pt=le,pt.setIndex(gt)),G.isMesh)k.wireframe===!0?(pe.setLineWidth(k.wireframeLinewidth*jn()),pt.setMode(F.LINES)):pt.setMode(F.TRIANGLES);else if(G.isLine){let ln=k.linewidth;ln===void 0&&(ln=1),pe.setLineWidth(ln*jn()),G.isLineSegments?pt.setMode(F.LINES):G.isLineLoop?pt.setMode(F.LINE_LOOP):pt.setMode(F.LINE_STRIP)}else G.isPoints?pt.setMode(F.POINTS):G.isSprite&&pt.setMode(F.TRIANGLES);if(G.isBatchedMesh)if(bt.get("WEBGL_multi_draw"))pt.renderMultiDraw(G._multiDrawStarts,G._multiDrawCounts,G._multiDrawCount);else{let ln=G._multiDrawStarts,Ae=G._multiDrawCounts,gn=G._multiDrawCount,it=_e?S.get(_e).bytesPerElement:1,js=Ne.get(k).currentProgram.getUniforms();for(let cn=0;cn<gn;cn++)js.setValue(F,"_gl_DrawID",cn),pt.render(ln[cn]/it,Ae[cn])}else if(G.isInstancedMesh)pt.renderInstances(we,Lt,G.count);else if(q.isInstancedBufferGeometry){let ln=q._maxInstanceCount!==void 0?q._maxInstanceCount:1/0,Ae=Math.min(q.instanceCount,ln);pt.renderInstances(we,Lt,Ae)}else pt.render(we,Lt)};function Rp(A,U,q,k){D!==null&&A.isNodeMaterial&&D.setObject(k,A),Dt===!0&&K.setState(A,q,!1),A.transparent===!0&&A.side===Ti&&A.forceSinglePass===!1?(A.side=Mn,A.needsUpdate=!0,Io(A,U,k),A.side=Ts,A.needsUpdate=!0,Io(A,U,k),A.side=Ti):Io(A,U,k)}this.compile=function(A,U,q=null){q===null&&(q=A),D!==null&&D.renderStart(A,U,q),E=Z.get(q),E.init(U),b.push(E),q.traverseVisible(function(G){G.isLight&&G.layers.test(U.layers)&&(E.pushLight(G),G.castShadow&&E.pushShadow(G))}),A!==q&&A.traverseVisible(function(G){G.isLight&&G.layers.test(U.layers)&&(E.pushLight(G),G.castShadow&&E.pushShadow(G))}),E.setupLights(),D!==null&&D.updateLights(E.state.lightsArray),In=this.localClippingEnabled,Dt=K.init(this.clippingPlanes,In),Dt===!0&&K.setGlobalState(this.clippingPlanes,U),D!==null&&ae.render(E.state.shadowsArray,q,U);let k=new Set;return A.traverse(function(G){if(!(G.isMesh||G.isPoints||G.isLine||G.isSprite))return;let he=G.material;if(he)if(Array.isArray(he))for(let Se=0;Se<he.length;Se++){let ce=he[Se];Rp(ce,q,U,G),k.add(ce)}else Rp(he,q,U,G),k.add(he)}),E=b.pop(),D!==null&&D.renderEnd(),k},this.compileAsync=function(A,U,q=null){let k=this.compile(A,U,q);return new Promise(G=>{function he(){if(k.forEach(function(Se){let _e=Ne.get(Se).currentProgram;(_e===void 0||_e.isReady())&&k.delete(Se)}),k.size===0){G(A);return}setTimeout(he,10)}bt.get("KHR_parallel_shader_compile")!==null?he():setTimeout(he,10)})};let Th=null;function lv(A){Th&&Th(A)}function Cp(){Zs.stop()}function Ip(){Zs.start()}let Zs=new Rg;Zs.setAnimationLoop(lv),typeof self<"u"&&Zs.setContext(self),this.setAnimationLoop=function(A){Th=A,ie.setAnimationLoop(A),A===null?Zs.stop():Zs.start()},ie.addEventListener("sessionstart",Cp),ie.addEventListener("sessionend",Ip),this.render=function(A,U){if(U!==void 0&&U.isCamera!==!0){Ue("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;D!==null&&D.renderStart(A,U);let q=ie.enabled===!0&&ie.isPresenting===!0,k=I!==null&&(ee===null||q)&&I.begin(T,ee);if(A.matrixWorldAutoUpdate===!0&&A.updateMatrixWorld(),U.parent===null&&U.matrixWorldAutoUpdate===!0&&U.updateMatrixWorld(),ie.enabled===!0&&ie.isPresenting===!0&&(I===null||I.isCompositing()===!1)&&(ie.cameraAutoUpdate===!0&&ie.updateCamera(U),U=ie.getCamera()),A.isScene===!0&&A.onBeforeRender(T,A,U,ee),E=Z.get(A,b.length),E.init(U),E.state.textureUnits=Be.getTextureUnits(),b.push(E),Et.multiplyMatrices(U.projectionMatrix,U.matrixWorldInverse),U.isArrayCamera?Qt.setFromArrayCamera(U):Ze.setFromProjectionMatrix(Et,Qn,U.reversedDepth),In=this.localClippingEnabled,Dt=K.init(this.clippingPlanes,In),w=ue.get(A,_.length),w.init(),_.push(w),this.info.render.frame++,ie.enabled===!0&&ie.isPresenting===!0){let Se=T.xr.getDepthSensingMesh();Se!==null&&Rh(Se,U,-1/0,T.sortObjects)}Rh(A,U,0,T.sortObjects),w.finish(),D!==null&&D.updateLights(E.state.lightsArray),T.sortObjects===!0&&w.sort(ze,Pt),Zn=ie.enabled===!1||ie.isPresenting===!1||ie.hasDepthSensing()===!1,Zn&&N.addToRenderList(w,A),this.info.autoReset===!0&&this.info.reset(),Dt===!0&&K.beginShadows();let G=E.state.shadowsArray;if(ae.render(G,A,U),Dt===!0&&K.endShadows(),(k&&I.hasRenderPass())===!1){let Se=w.opaque,ce=w.transmissive;if(E.setupLights(),U.isArrayCamera){let _e=U.cameras;if(ce.length>0)for(let Ee=0,ke=_e.length;Ee<ke;Ee++){let je=_e[Ee];Lp(Se,ce,A,je)}Zn&&N.render(A);for(let Ee=0,ke=_e.length;Ee<ke;Ee++){let je=_e[Ee];Pp(w,A,je,je.viewport)}}else ce.length>0&&Lp(Se,ce,A,U),Zn&&N.render(A),Pp(w,A,U)}ee!==null&&V===0&&(Be.updateMultisampleRenderTarget(ee),Be.updateRenderTargetMipmap(ee)),k&&I.end(T),A.isScene===!0&&A.onAfterRender(T,A,U),oe.resetDefaultState(),X=-1,j=null,b.pop(),b.length>0?(E=b[b.length-1],Be.setTextureUnits(E.state.textureUnits),Dt===!0&&K.setGlobalState(T.clippingPlanes,E.state.camera)):E=null,_.pop(),_.length>0?w=_[_.length-1]:w=null,D!==null&&D.renderEnd()};function Rh(A,U,q,k){if(A.visible===!1)return;if(A.layers.test(U.layers)){if(A.isGroup)q=A.renderOrder;else if(A.isLOD)A.autoUpdate===!0&&A.update(U);else if(A.isLight)E.pushLight(A),A.castShadow&&E.pushShadow(A);else if(A.isSprite){let Se=U.isArrayCamera?Qt:Ze;if(!A.frustumCulled||A.intersectsFrustum(Se)){k&&Vt.setFromMatrixPosition(A.matrixWorld).applyMatrix4(Et);let ce=ne.update(A),_e=A.material;_e.visible&&w.push(A,ce,_e,q,Vt.z,null,U)}}else if(A.isMesh||A.isLine||A.isPoints){let Se=U.isArrayCamera?Qt:Ze;if(!A.frustumCulled||A.intersectsFrustum(Se)){let ce=ne.update(A),_e=A.material;if(k&&(A.boundingSphere!==void 0?(A.boundingSphere===null&&A.computeBoundingSphere(),Vt.copy(A.boundingSphere.center)):(ce.boundingSphere===null&&ce.computeBoundingSphere(),Vt.copy(ce.boundingSphere.center)),Vt.applyMatrix4(A.matrixWorld).applyMatrix4(Et)),Array.isArray(_e)){let Ee=ce.groups;for(let ke=0,je=Ee.length;ke<je;ke++){let we=Ee[ke],Ke=_e[we.materialIndex];Ke&&Ke.visible&&w.push(A,ce,Ke,q,Vt.z,we,U)}}else _e.visible&&w.push(A,ce,_e,q,Vt.z,null,U)}}}let he=A.children;for(let Se=0,ce=he.length;Se<ce;Se++)Rh(he[Se],U,q,k)}function Pp(A,U,q,k){let{opaque:G,transmissive:he,transparent:Se}=A;E.setupLightsView(q),Dt===!0&&K.setGlobalState(T.clippingPlanes,q),k&&pe.viewport(te.copy(k)),G.length>0&&nl(G,U,q),he.length>0&&nl(he,U,q),Se.length>0&&nl(Se,U,q),pe.buffers.depth.setTest(!0),pe.buffers.depth.setMask(!0),pe.buffers.color.setMask(!0),pe.setPolygonOffset(!1)}function Lp(A,U,q,k){if((q.isScene===!0?q.overrideMaterial:null)!==null)return;if(E.state.transmissionRenderTarget[k.id]===void 0){let we=bt.has("EXT_color_buffer_half_float")||bt.has("EXT_color_buffer_float");E.state.transmissionRenderTarget[k.id]=new kn(1,1,{generateMipmaps:!0,type:we?mi:Dn,minFilter:Ji,samples:Math.max(4,St.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Je.workingColorSpace})}let he=E.state.transmissionRenderTarget[k.id],Se=k.viewport||te;he.setSize(Se.z*T.transmissionResolutionScale,Se.w*T.transmissionResolutionScale);let ce=T.getRenderTarget(),_e=T.getActiveCubeFace(),Ee=T.getActiveMipmapLevel();T.setRenderTarget(he),T.getClearColor(Y),me=T.getClearAlpha(),me<1&&T.setClearColor(16777215,.5),T.clear(),Zn&&N.render(q);let ke=T.toneMapping;T.toneMapping=Ri;let je=k.viewport;if(k.viewport!==void 0&&(k.viewport=void 0),E.setupLightsView(k),Dt===!0&&K.setGlobalState(T.clippingPlanes,k),nl(A,q,k),Be.updateMultisampleRenderTarget(he),Be.updateRenderTargetMipmap(he),bt.has("WEBGL_multisampled_render_to_texture")===!1){let we=!1;for(let Ke=0,Lt=U.length;Ke<Lt;Ke++){let gt=U[Ke],{object:pt,geometry:ln,material:Ae,group:gn}=gt;if(Ae.side===Ti&&pt.layers.test(k.layers)){let it=Ae.side;Ae.side=Mn,Ae.needsUpdate=!0,Np(pt,q,k,ln,Ae,gn),Ae.side=it,Ae.needsUpdate=!0,we=!0}}we===!0&&(Be.updateMultisampleRenderTarget(he),Be.updateRenderTargetMipmap(he))}T.setRenderTarget(ce,_e,Ee),T.setClearColor(Y,me),je!==void 0&&(k.viewport=je),T.toneMapping=ke}function nl(A,U,q){let k=U.isScene===!0?U.overrideMaterial:null;for(let G=0,he=A.length;G<he;G++){let Se=A[G],{object:ce,geometry:_e,group:Ee}=Se,ke=Se.material;ke.allowOverride===!0&&k!==null&&(ke=k),ce.layers.test(q.layers)&&Np(ce,U,q,_e,ke,Ee)}}function Np(A,U,q,k,G,he){D!==null&&G.isNodeMaterial&&D.setObject(A,G),A.onBeforeRender(T,U,q,k,G,he),A.modelViewMatrix.multiplyMatrices(q.matrixWorldInverse,A.matrixWorld),A.normalMatrix.getNormalMatrix(A.modelViewMatrix),G.onBeforeRender(T,U,q,k,A,he),G.transparent===!0&&G.side===Ti&&G.forceSinglePass===!1?(G.side=Mn,G.needsUpdate=!0,T.renderBufferDirect(q,U,k,G,A,he),G.side=Ts,G.needsUpdate=!0,T.renderBufferDirect(q,U,k,G,A,he),G.side=Ti):T.renderBufferDirect(q,U,k,G,A,he),A.onAfterRender(T,U,q,k,G,he)}function Dp(A){let U=0;for(let q of A)q.texture!==null&&U++;return U}function Io(A,U,q){U.isScene!==!0&&(U=Yn);let k=Ne.get(A),G=E.state.lights,he=E.state.shadowsArray,Se=G.state.version,ce=Q.getParameters(A,G.state,he,U,q,E.state.lightProbeGridArray),_e=Q.getProgramCacheKey(ce),Ee=k.programs;k.environment=A.isMeshStandardMaterial||A.isMeshLambertMaterial||A.isMeshPhongMaterial?U.environment:null,k.fog=U.fog;let ke=A.isMeshStandardMaterial||A.isMeshLambertMaterial&&!A.envMap||A.isMeshPhongMaterial&&!A.envMap;k.envMap=R.get(A.envMap||k.environment,ke),k.envMapRotation=k.environment!==null&&A.envMap===null?U.environmentRotation:A.envMapRotation,Ee===void 0&&(A.addEventListener("dispose",ct),Ee=new Map,k.programs=Ee,k.programVariants=new Map);let je=Ee.get(_e);if(je!==void 0){if(k.currentProgram===je&&k.lightsStateVersion===Se)return Fp(A,ce),je}else ce.uniforms=Q.getUniforms(A),D!==null&&A.isNodeMaterial&&D.build(A,q,ce),A.onBeforeCompile(ce,T),je=Q.acquireProgram(ce,_e),Ee.set(_e,je),k.uniforms=ce.uniforms;let we=k.uniforms;return(!A.isShaderMaterial&&!A.isRawShaderMaterial||A.clipping===!0)&&(we.clippingPlanes=K.uniform),Fp(A,ce),k.needsLights=dv(A),k.lightsStateVersion=Se,k.needsLights&&(we.ambientLightColor.value=G.state.ambient,we.lightProbe.value=G.state.probe,we.sunLights.value=G.state.sun,we.sunLightShadows.value=G.state.sunShadow,we.directionalLights.value=G.state.directional,we.directionalLightShadows.value=G.state.directionalShadow,we.spotLights.value=G.state.spot,we.spotLightShadows.value=G.state.spotShadow,we.rectAreaLights.value=G.state.rectArea,we.ltc_1.value=G.state.rectAreaLTC1,we.ltc_2.value=G.state.rectAreaLTC2,we.pointLights.value=G.state.point,we.pointLightShadows.value=G.state.pointShadow,we.hemisphereLights.value=G.state.hemi,we.sunShadowMatrix.value=G.state.sunShadowMatrix,we.sunShadowCascade.value=G.state.sunShadowCascade,we.directionalShadowMatrix.value=G.state.directionalShadowMatrix,we.spotLightMatrix.value=G.state.spotLightMatrix,we.spotLightMap.value=G.state.spotLightMap,we.pointShadowMatrix.value=G.state.pointShadowMatrix),k.numLightProbeGrids=Dp(E.state.lightProbeGridArray),k.currentProgram=je,k.uniformsList=null,je}function cv(A,U,q,k,G){let he=Ne.get(A),Se=he.currentProgram.id+","+k+","+G,ce=he.programVariants.get(Se);return ce===void 0?(ce=Io(A,U,q),he.programVariants.set(Se,ce)):(he.currentProgram=ce,he.uniformsList=null,he.outputColorSpace=k,he.toneMapping=G),ce}function Up(A){if(A.uniformsList===null){let U=A.currentProgram.getUniforms();A.uniformsList=eo.seqWithValue(U.seq,A.uniforms)}return A.uniformsList}function Fp(A,U){let q=Ne.get(A);q.outputColorSpace=U.outputColorSpace,q.batching=U.batching,q.batchingColor=U.batchingColor,q.instancing=U.instancing,q.instancingColor=U.instancingColor,q.instancingMorph=U.instancingMorph,q.skinning=U.skinning,q.morphTargets=U.morphTargets,q.morphNormals=U.morphNormals,q.morphColors=U.morphColors,q.morphTargetsCount=U.morphTargetsCount,q.numClippingPlanes=U.numClippingPlanes,q.numIntersection=U.numClipIntersection,q.vertexAlphas=U.vertexAlphas,q.vertexTangents=U.vertexTangents,q.toneMapping=U.toneMapping}function uv(A,U,q,k,G){U.isScene!==!0&&(U=Yn),Be.resetTextureUnits();let he=U.fog,Se=k.isMeshStandardMaterial||k.isMeshLambertMaterial||k.isMeshPhongMaterial?U.environment:null,ce=ee===null?T.outputColorSpace:ee.isXRRenderTarget===!0?ee.texture.colorSpace:Je.workingColorSpace,_e=k.isMeshStandardMaterial||k.isMeshLambertMaterial&&!k.envMap||k.isMeshPhongMaterial&&!k.envMap,Ee=R.get(k.envMap||Se,_e),ke=k.vertexColors===!0&&!!q.attributes.color&&q.attributes.color.itemSize===4,je=!!q.attributes.tangent&&(!!k.normalMap||k.anisotropy>0),we=!!q.morphAttributes.position,Ke=!!q.morphAttributes.normal,Lt=!!q.morphAttributes.color,gt=Ri;k.toneMapped&&(ee===null||ee.isXRRenderTarget===!0)&&(gt=T.toneMapping);let pt=q.morphAttributes.position||q.morphAttributes.normal||q.morphAttributes.color,ln=pt!==void 0?pt.length:0,Ae=Ne.get(k),gn=E.state.lights;if(Dt===!0&&(In===!0||A!==j)){let Tt=A===j&&k.id===X;K.setState(k,A,Tt)}let it=!1,js=!1;k.version===Ae.__version?Ae.needsLights&&Ae.lightsStateVersion!==gn.state.version||G.isBatchedMesh&&Ae.batching===!1||!G.isBatchedMesh&&Ae.batching===!0||G.isBatchedMesh&&Ae.batchingColor===!0&&G._colorsTexture===null||G.isBatchedMesh&&Ae.batchingColor===!1&&G._colorsTexture!==null||G.isInstancedMesh&&Ae.instancing===!1||!G.isInstancedMesh&&Ae.instancing===!0||G.isSkinnedMesh&&Ae.skinning===!1||!G.isSkinnedMesh&&Ae.skinning===!0||G.isInstancedMesh&&Ae.instancingColor===!0&&G.instanceColor===null||G.isInstancedMesh&&Ae.instancingColor===!1&&G.instanceColor!==null||G.isInstancedMesh&&Ae.instancingMorph===!0&&G.morphTexture===null||G.isInstancedMesh&&Ae.instancingMorph===!1&&G.morphTexture!==null||Ae.envMap!==Ee||k.fog===!0&&Ae.fog!==he||Ae.numClippingPlanes!==void 0&&(Ae.numClippingPlanes!==K.numPlanes||Ae.numIntersection!==K.numIntersection)||Ae.vertexAlphas!==ke||Ae.vertexTangents!==je||Ae.morphTargets!==we||Ae.morphNormals!==Ke||Ae.morphColors!==Lt||Ae.morphTargetsCount!==ln||Ae.numLightProbeGrids!==Dp(E.state.lightProbeGridArray)?it=!0:(Ae.outputColorSpace!==ce||Ae.toneMapping!==gt)&&(js=!0):(it=!0,Ae.__version=k.version);let cn=Ae.currentProgram;(it===!0||js===!0)&&(cn=js===!0?cv(k,U,G,ce,gt):Io(k,U,G),D&&k.isNodeMaterial&&D.onUpdateProgram(k,cn,Ae));let il=!1,fs=!1,Ks=!1,nt=cn.getUniforms(),en=Ae.uniforms;if(pe.useProgram(cn.program)&&(il=!0,fs=!0,Ks=!0),k.id!==X&&(X=k.id,fs=!0),il||j!==A){pe.buffers.depth.getReversed()&&A.reversedDepth!==!0&&(A._reversedDepth=!0,A.updateProjectionMatrix()),nt.setValue(F,"projectionMatrix",A.projectionMatrix),nt.setValue(F,"viewMatrix",A.matrixWorldInverse);let Wt=nt.map.cameraPosition;Wt!==void 0&&Wt.setValue(F,bi.setFromMatrixPosition(A.matrixWorld)),St.logarithmicDepthBuffer&&nt.setValue(F,"logDepthBufFC",2/(Math.log(A.far+1)/Math.LN2)),(k.isMeshPhongMaterial||k.isMeshToonMaterial||k.isMeshLambertMaterial||k.isMeshBasicMaterial||k.isMeshStandardMaterial||k.isShaderMaterial)&&nt.setValue(F,"isOrthographic",A.isOrthographicCamera===!0),j!==A&&(j=A,fs=!0,Ks=!0)}if(Ae.needsLights&&(gn.state.sunShadowMap.length>0&&nt.setValue(F,"sunShadowMap",gn.state.sunShadowMap,Be),gn.state.directionalShadowMap.length>0&&nt.setValue(F,"directionalShadowMap",gn.state.directionalShadowMap,Be),gn.state.spotShadowMap.length>0&&nt.setValue(F,"spotShadowMap",gn.state.spotShadowMap,Be),gn.state.pointShadowMap.length>0&&nt.setValue(F,"pointShadowMap",gn.state.pointShadowMap,Be)),G.isSkinnedMesh){nt.setOptional(F,G,"bindMatrix"),nt.setOptional(F,G,"bindMatrixInverse");let Tt=G.skeleton;Tt&&(Tt.boneTexture===null&&Tt.computeBoneTexture(),nt.setValue(F,"boneTexture",Tt.boneTexture,Be))}G.isBatchedMesh&&(nt.setOptional(F,G,"batchingTexture"),nt.setValue(F,"batchingTexture",G._matricesTexture,Be),nt.setOptional(F,G,"batchingIdTexture"),nt.setValue(F,"batchingIdTexture",G._indirectTexture,Be),nt.setOptional(F,G,"batchingColorTexture"),G._colorsTexture!==null&&nt.setValue(F,"batchingColorTexture",G._colorsTexture,Be));let ai=q.morphAttributes;if((ai.position!==void 0||ai.normal!==void 0||ai.color!==void 0)&&J.update(G,q,cn),(fs||Ae.receiveShadow!==G.receiveShadow)&&(Ae.receiveShadow=G.receiveShadow,nt.setValue(F,"receiveShadow",G.receiveShadow)),(k.isMeshStandardMaterial||k.isMeshLambertMaterial||k.isMeshPhongMaterial)&&k.envMap===null&&U.environment!==null&&(en.envMapIntensity.value=U.environmentIntensity),en.dfgLUT!==void 0&&(en.dfgLUT.value=iA()),fs){if(nt.setValue(F,"toneMappingExposure",T.toneMappingExposure),Ae.needsLights&&hv(en,Ks),he&&k.fog===!0&&re.refreshFogUniforms(en,he),re.refreshMaterialUniforms(en,k,ye,Le,E.state.transmissionRenderTarget[A.id]),Ae.needsLights&&Ae.numLightProbeGrids>0){let Tt=M,Wt=0;for(let Gi of E.state.lightProbeGridArray)Gi.texture!==null&&(Tt.textures[Wt]=Gi.texture,Tt.min[Wt]=Gi.boundingBox.min,Tt.max[Wt]=Gi.boundingBox.max,Tt.resolution[Wt]=Gi.resolution,Wt++);for(let Gi in Tt)Tt[Gi].length=Wt;en.probesSH.value=Tt.textures,en.probesMin.value=Tt.min,en.probesMax.value=Tt.max,en.probesResolution.value=Tt.resolution}eo.upload(F,Up(Ae),en,Be)}if(k.isShaderMaterial&&k.uniformsNeedUpdate===!0&&(eo.upload(F,Up(Ae),en,Be),k.uniformsNeedUpdate=!1),k.isSpriteMaterial&&nt.setValue(F,"center",G.center),nt.setValue(F,"modelViewMatrix",G.modelViewMatrix),nt.setValue(F,"normalMatrix",G.normalMatrix),nt.setValue(F,"modelMatrix",G.matrixWorld),k.uniformsGroups!==void 0){let Tt=k.uniformsGroups;for(let Wt=0,Gi=Tt.length;Wt<Gi;Wt++){let Bp=Tt[Wt];Re.update(Bp,cn),Re.bind(Bp,cn)}}return cn}function hv(A,U){A.ambientLightColor.needsUpdate=U,A.lightProbe.needsUpdate=U,A.sunLights.needsUpdate=U,A.sunLightShadows.needsUpdate=U,A.directionalLights.needsUpdate=U,A.directionalLightShadows.needsUpdate=U,A.pointLights.needsUpdate=U,A.pointLightShadows.needsUpdate=U,A.spotLights.needsUpdate=U,A.spotLightShadows.needsUpdate=U,A.rectAreaLights.needsUpdate=U,A.hemisphereLights.needsUpdate=U}function dv(A){return A.isMeshLambertMaterial||A.isMeshToonMaterial||A.isMeshPhongMaterial||A.isMeshStandardMaterial||A.isShadowMaterial||A.isShaderMaterial&&A.lights===!0}this.getActiveCubeFace=function(){return H},this.getActiveMipmapLevel=function(){return V},this.getRenderTarget=function(){return ee},this.setRenderTargetTextures=function(A,U,q){let k=Ne.get(A);k.__autoAllocateDepthBuffer=A.resolveDepthBuffer===!1,k.__autoAllocateDepthBuffer===!1&&(k.__useRenderToTexture=!1),Ne.get(A.texture).__webglTexture=U,Ne.get(A.depthTexture).__webglTexture=k.__autoAllocateDepthBuffer?void 0:q,k.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(A,U){let q=Ne.get(A);q.__webglFramebuffer=U,q.__useDefaultFramebuffer=U===void 0},this.setRenderTarget=function(A,U=0,q=0){ee=A,H=U,V=q;let k=null,G=!1,he=!1;if(A){let ce=Ne.get(A);if(ce.__useDefaultFramebuffer!==void 0){pe.bindFramebuffer(F.FRAMEBUFFER,ce.__webglFramebuffer),te.copy(A.viewport),ve.copy(A.scissor),Pe=A.scissorTest,pe.viewport(te),pe.scissor(ve),pe.setScissorTest(Pe),X=-1;return}else if(ce.__webglFramebuffer===void 0)Be.setupRenderTarget(A);else if(ce.__hasExternalTextures)Be.rebindTextures(A,Ne.get(A.texture).__webglTexture,Ne.get(A.depthTexture).__webglTexture);else if(A.depthBuffer){let ke=A.depthTexture;if(ce.__boundDepthTexture!==ke){if(ke!==null&&Ne.has(ke)&&(A.width!==ke.image.width||A.height!==ke.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Be.setupDepthRenderbuffer(A)}}let _e=A.texture;(_e.isData3DTexture||_e.isDataArrayTexture||_e.isCompressedArrayTexture)&&(he=!0);let Ee=Ne.get(A).__webglFramebuffer;A.isWebGLCubeRenderTarget?(Array.isArray(Ee[U])?k=Ee[U][q]:k=Ee[U],G=!0):A.samples>0&&Be.useMultisampledRTT(A)===!1?k=Ne.get(A).__webglMultisampledFramebuffer:Array.isArray(Ee)?k=Ee[q]:k=Ee,te.copy(A.viewport),ve.copy(A.scissor),Pe=A.scissorTest}else te.copy(De).multiplyScalar(ye).floor(),ve.copy(lt).multiplyScalar(ye).floor(),Pe=ft;if(q!==0&&(k=B),pe.bindFramebuffer(F.FRAMEBUFFER,k)&&pe.drawBuffers(A,k),pe.viewport(te),pe.scissor(ve),pe.setScissorTest(Pe),G){let ce=Ne.get(A.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_CUBE_MAP_POSITIVE_X+U,ce.__webglTexture,q)}else if(he){let ce=U;for(let _e=0;_e<A.textures.length;_e++){let Ee=Ne.get(A.textures[_e]);F.framebufferTextureLayer(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0+_e,Ee.__webglTexture,q,ce)}}else if(A!==null&&q!==0){let ce=Ne.get(A.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,ce.__webglTexture,q)}X=-1};function Op(A){let U=Ne.get(A);return(U.__readFormat!==A.format||U.__readType!==A.type)&&(U.__readFormat=A.format,U.__readType=A.type,U.__formatReadable=St.textureFormatReadable(A.format),U.__typeReadable=St.textureTypeReadable(A.type)),U}this.readRenderTargetPixels=function(A,U,q,k,G,he,Se,ce=0){if(!(A&&A.isWebGLRenderTarget)){Ue("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let _e=Ne.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&Se!==void 0&&(_e=_e[Se],Array.isArray(_e)&&(_e=_e[0])),_e){pe.bindFramebuffer(F.FRAMEBUFFER,_e);try{let Ee=A.textures[ce],ke=Ee.format,je=Ee.type;A.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+ce);let we=Op(Ee);if(we.__formatReadable===!1){Ue("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(we.__typeReadable===!1){Ue("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}U>=0&&U<=A.width-k&&q>=0&&q<=A.height-G&&F.readPixels(U,q,k,G,se.convert(ke),se.convert(je),he)}finally{let Ee=ee!==null?Ne.get(ee).__webglFramebuffer:null;pe.bindFramebuffer(F.FRAMEBUFFER,Ee)}}},this.readRenderTargetPixelsAsync=async function(A,U,q,k,G,he,Se,ce=0){if(!(A&&A.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let _e=Ne.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&Se!==void 0&&(_e=_e[Se],Array.isArray(_e)&&(_e=_e[0])),_e)if(U>=0&&U<=A.width-k&&q>=0&&q<=A.height-G){pe.bindFramebuffer(F.FRAMEBUFFER,_e);let Ee=A.textures[ce],ke=Ee.format,je=Ee.type;A.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+ce);let we=Op(Ee);if(we.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(we.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let Ke=F.createBuffer();F.bindBuffer(F.PIXEL_PACK_BUFFER,Ke),F.bufferData(F.PIXEL_PACK_BUFFER,he.byteLength,F.STREAM_READ),F.readPixels(U,q,k,G,se.convert(ke),se.convert(je),0),F.bindBuffer(F.PIXEL_PACK_BUFFER,null);let Lt=ee!==null?Ne.get(ee).__webglFramebuffer:null;pe.bindFramebuffer(F.FRAMEBUFFER,Lt);let gt=F.fenceSync(F.SYNC_GPU_COMMANDS_COMPLETE,0);return F.flush(),await ng(F,gt,4),F.bindBuffer(F.PIXEL_PACK_BUFFER,Ke),F.getBufferSubData(F.PIXEL_PACK_BUFFER,0,he),F.bindBuffer(F.PIXEL_PACK_BUFFER,null),F.deleteBuffer(Ke),F.deleteSync(gt),he}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(A,U=null,q=0){let k=Math.pow(2,-q),G=Math.floor(A.image.width*k),he=Math.floor(A.image.height*k),Se=U!==null?U.x:0,ce=U!==null?U.y:0;Be.setTexture2D(A,0),F.copyTexSubImage2D(F.TEXTURE_2D,q,0,0,Se,ce,G,he),pe.unbindTexture()},this.copyTextureToTexture=function(A,U,q=null,k=null,G=0,he=0){let Se,ce,_e,Ee,ke,je,we,Ke,Lt,gt=A.isCompressedTexture?A.mipmaps[he]:A.image;if(q!==null)Se=q.max.x-q.min.x,ce=q.max.y-q.min.y,_e=q.isBox3?q.max.z-q.min.z:1,Ee=q.min.x,ke=q.min.y,je=q.isBox3?q.min.z:0;else{let nt=Math.pow(2,-G);Se=Math.floor(gt.width*nt),ce=Math.floor(gt.height*nt),A.isDataArrayTexture?_e=gt.depth:A.isData3DTexture?_e=Math.floor(gt.depth*nt):_e=1,Ee=0,ke=0,je=0}k!==null?(we=k.x,Ke=k.y,Lt=k.z):(we=0,Ke=0,Lt=0);let pt=se.convert(U.format),ln=se.convert(U.type),Ae;U.isData3DTexture?(Be.setTexture3D(U,0),Ae=F.TEXTURE_3D):U.isDataArrayTexture||U.isCompressedArrayTexture?(Be.setTexture2DArray(U,0),Ae=F.TEXTURE_2D_ARRAY):(Be.setTexture2D(U,0),Ae=F.TEXTURE_2D),pe.activeTexture(F.TEXTURE0),pe.pixelStorei(F.UNPACK_FLIP_Y_WEBGL,U.flipY),pe.pixelStorei(F.UNPACK_PREMULTIPLY_ALPHA_WEBGL,U.premultiplyAlpha),pe.pixelStorei(F.UNPACK_ALIGNMENT,U.unpackAlignment);let gn=pe.getParameter(F.UNPACK_ROW_LENGTH),it=pe.getParameter(F.UNPACK_IMAGE_HEIGHT),js=pe.getParameter(F.UNPACK_SKIP_PIXELS),cn=pe.getParameter(F.UNPACK_SKIP_ROWS),il=pe.getParameter(F.UNPACK_SKIP_IMAGES);pe.pixelStorei(F.UNPACK_ROW_LENGTH,gt.width),pe.pixelStorei(F.UNPACK_IMAGE_HEIGHT,gt.height),pe.pixelStorei(F.UNPACK_SKIP_PIXELS,Ee),pe.pixelStorei(F.UNPACK_SKIP_ROWS,ke),pe.pixelStorei(F.UNPACK_SKIP_IMAGES,je);let fs=A.isDataArrayTexture||A.isData3DTexture,Ks=U.isDataArrayTexture||U.isData3DTexture;if(A.isDepthTexture){let nt=Ne.get(A),en=Ne.get(U),ai=Ne.get(nt.__renderTarget),Tt=Ne.get(en.__renderTarget);pe.bindFramebuffer(F.READ_FRAMEBUFFER,ai.__webglFramebuffer),pe.bindFramebuffer(F.DRAW_FRAMEBUFFER,Tt.__webglFramebuffer);for(let Wt=0;Wt<_e;Wt++)fs&&(F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,Ne.get(A).__webglTexture,G,je+Wt),F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,Ne.get(U).__webglTexture,he,Lt+Wt)),F.blitFramebuffer(Ee,ke,Ee+Se,ke+ce,we,Ke,we+Se,Ke+ce,F.DEPTH_BUFFER_BIT,F.NEAREST);pe.bindFramebuffer(F.READ_FRAMEBUFFER,null),pe.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else if(G!==0||A.isRenderTargetTexture||Ne.has(A)){let nt=Ne.get(A),en=Ne.get(U);pe.bindFramebuffer(F.READ_FRAMEBUFFER,P),pe.bindFramebuffer(F.DRAW_FRAMEBUFFER,O);for(let ai=0;ai<_e;ai++)fs?F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,nt.__webglTexture,G,je+ai):F.framebufferTexture2D(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,nt.__webglTexture,G),Ks?F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,en.__webglTexture,he,Lt+ai):F.framebufferTexture2D(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,en.__webglTexture,he),G!==0?F.blitFramebuffer(Ee,ke,Ee+Se,ke+ce,we,Ke,we+Se,Ke+ce,F.COLOR_BUFFER_BIT,F.NEAREST):Ks?F.copyTexSubImage3D(Ae,he,we,Ke,Lt+ai,Ee,ke,Se,ce):F.copyTexSubImage2D(Ae,he,we,Ke,Ee,ke,Se,ce);pe.bindFramebuffer(F.READ_FRAMEBUFFER,null),pe.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else Ks?A.isDataTexture||A.isData3DTexture?F.texSubImage3D(Ae,he,we,Ke,Lt,Se,ce,_e,pt,ln,gt.data):U.isCompressedArrayTexture?F.compressedTexSubImage3D(Ae,he,we,Ke,Lt,Se,ce,_e,pt,gt.data):F.texSubImage3D(Ae,he,we,Ke,Lt,Se,ce,_e,pt,ln,gt):A.isDataTexture?F.texSubImage2D(F.TEXTURE_2D,he,we,Ke,Se,ce,pt,ln,gt.data):A.isCompressedTexture?F.compressedTexSubImage2D(F.TEXTURE_2D,he,we,Ke,gt.width,gt.height,pt,gt.data):F.texSubImage2D(F.TEXTURE_2D,he,we,Ke,Se,ce,pt,ln,gt);pe.pixelStorei(F.UNPACK_ROW_LENGTH,gn),pe.pixelStorei(F.UNPACK_IMAGE_HEIGHT,it),pe.pixelStorei(F.UNPACK_SKIP_PIXELS,js),pe.pixelStorei(F.UNPACK_SKIP_ROWS,cn),pe.pixelStorei(F.UNPACK_SKIP_IMAGES,il),he===0&&U.generateMipmaps===!0&&U.mipmapsAutoUpdate===!0&&F.generateMipmap(Ae),pe.unbindTexture()},this.initRenderTarget=function(A){Ne.get(A).__webglFramebuffer===void 0&&Be.setupRenderTarget(A)},this.initTexture=function(A){A.isCubeTexture?Be.setTextureCube(A,0):A.isData3DTexture?Be.setTexture3D(A,0):A.isDataArrayTexture||A.isCompressedArrayTexture?Be.setTexture2DArray(A,0):Be.setTexture2D(A,0),pe.unbindTexture()},this.resetState=function(){H=0,V=0,ee=null,pe.reset(),oe.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Qn}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=Je._getDrawingBufferColorSpace(e),t.unpackColorSpace=Je._getUnpackColorSpace()}};var du=26,uu=.1,kg=1.55,[sA,rA]=[.4,6],oA=5,hu=class{constructor(e){this.azimuth=.52,this.elevation=.38,this.zoom=1,this.onChange=e,this.taken=null,document.addEventListener("pointerdown",t=>t.target!==this.taken&&this.letGo(),{capture:!0}),document.addEventListener("keydown",t=>t.key==="Escape"&&this.letGo())}take(e){this.letGo(),this.taken=e,e.parentElement.classList.add("held")}letGo(){this.taken?.parentElement?.classList.remove("held"),this.taken=null}turn(e,t){this.azimuth-=e,this.elevation=Math.min(kg,Math.max(-kg,this.elevation+t)),this.onChange()}closer(e){this.zoom=Math.min(rA,Math.max(sA,this.zoom*e)),this.onChange()}place(e,t,i,s){let r=du*Math.PI/360,o=Math.min(r,Math.atan(Math.tan(r)*s)),a=i/Math.sin(o)/this.zoom,[l,c]=[Math.cos(this.elevation),Math.sin(this.elevation)];e.position.set(l*Math.cos(this.azimuth),l*Math.sin(this.azimuth),c).multiplyScalar(a).add(t),e.up.set(0,0,1),e.aspect=s,e.near=Math.max(a-4*i,a/100),e.far=a+8*i,e.lookAt(t),e.updateProjectionMatrix(),e.updateMatrixWorld()}listen(e){let t=new Map,i=null,s=()=>{let[r,o]=[...t.values()];return Math.hypot(r[0]-o[0],r[1]-o[1])};e.addEventListener("pointerdown",r=>{r.button===0&&(i=[r.clientX,r.clientY],t.set(r.pointerId,i),e.setPointerCapture(r.pointerId))}),e.addEventListener("mousedown",r=>r.preventDefault()),e.addEventListener("pointermove",r=>{let o=t.get(r.pointerId);if(!o)return;let a=t.size===2?s():0;t.set(r.pointerId,[r.clientX,r.clientY]),t.size===2?this.closer(s()/Math.max(a,1)):t.size===1&&this.turn((r.clientX-o[0])*.008,(r.clientY-o[1])*.008)});for(let r of["pointerup","pointercancel"])e.addEventListener(r,o=>t.delete(o.pointerId));e.addEventListener("pointerup",r=>{i&&Math.hypot(r.clientX-i[0],r.clientY-i[1])<oA&&r.pointerType==="mouse"&&this.take(e),i=null}),e.addEventListener("wheel",r=>this.wheel(r,e),{passive:!1})}wheel(e,t){this.taken!==t&&!e.ctrlKey||(e.preventDefault(),this.closer(Math.exp(-.002*(e.deltaY||e.deltaX))))}key(e){let t={ArrowLeft:[uu,0],ArrowRight:[-uu,0],ArrowUp:[0,uu],ArrowDown:[0,-uu]};if(t[e])this.turn(...t[e]);else if(e==="PageUp")this.closer(1.15);else if(e==="PageDown")this.closer(1/1.15);else return!1;return!0}},zg=()=>new yn(du,1,.1,100),Kd=new C(0,0,0);var Un={language:"en",mark:".",languages:[],table:{}},Gg=({languages:n,table:e})=>Object.assign(Un,{languages:n,table:e}),aA=n=>globalThis.polhodeWords?.[n],cr=()=>[...new Set(["en",...Un.languages,...Object.keys(globalThis.polhodeWords??{})])];function Vg(n){return n.map(t=>String(t).toLowerCase().split("-")[0]).find(t=>cr().includes(t))??"en"}function Hg(n){let e=new Intl.NumberFormat(n).formatToParts(1.5).find(({type:t})=>t==="decimal").value;Object.assign(Un,{language:n,mark:e})}var fu=()=>Un.language;function W(n,e=null){if(Array.isArray(n))return W(...n);let t=lA(n,Un.language)??n;return e?t.replace(/\{(\w+)\}/g,(i,s)=>Object.hasOwn(e,s)?cA(e[s]):i):t}function lA(n,e){let t=aA(e);if(t&&Object.hasOwn(t,n))return t[n];if(Object.hasOwn(Un.table,n))return Un.table[n][Un.languages.indexOf(e)]||void 0}var cA=n=>typeof n=="number"?$t(String(n)):n,$t=n=>Un.mark==="."?n:n.replace(/(\d)\.(?=\d)/g,`$1${Un.mark}`),no=n=>n.map($t).join(Un.mark===","?"; ":", ");function Wg(n){let{language:e,mark:t}=Un;Object.assign(Un,{language:"en",mark:"."});try{return n()}finally{Object.assign(Un,{language:e,mark:t})}}var qg=new Map,Is=({key:n,usual:e=!0})=>qg.get(n)??e,Xg=(n,e)=>qg.set(n,e),io=(n,e,t,i=!0)=>({key:n,color:e,text:t,usual:i});var pu=n=>document.getElementById(n);function Jd({name:n,title:e=n,summary:t,notes:i}){pu("name").textContent=W(e),pu("summary").textContent=W(t),pu("notes").replaceChildren(...i.map(s=>Ps("li",W(s))))}function Ps(n,e,t=""){let i=document.createElement(n);return i.textContent=e,t&&(i.className=t),i}function $g(n,e){let t=document.createElement("figure");t.className=n.flat?"panel flat":"panel";let i=document.createElement("canvas");i.setAttribute("role","img"),n.flat||(i.tabIndex=0,e.listen(i),i.addEventListener("keydown",r=>{e.key(r.key)&&r.preventDefault()}));let s=document.createElement("button");return s.type="button",s.className="enlarge",t.append(i,document.createElement("figcaption"),s),pu("panels").append(t),i}function Yg(n,e,t,i=()=>{}){let s=n.nextElementSibling,r=e.title==="The body in space"&&t.up==="L"?"L points up":"",o=Ps("span",[e.words,r].filter(Boolean).map(u=>W(u)).join("; "),"words"),a=Ps("span","","legend");for(let u of e.legend)a.append(uA(u,i));let l=Ps("span","","heading");l.append(Ps("strong",W(e.title)),o),s.replaceChildren(l,a),s.nextElementSibling.setAttribute("aria-label",W("Make large: {picture}",{picture:W(e.title)}));let c=e.flat?"":` ${W("Arrow keys turn the view, page up and down bring it closer.")}`;n.setAttribute("aria-label",`${[e.title,e.words].filter(Boolean).map(u=>W(u)).join(": ")}.${c}`),n.parentElement.dataset.held=W("The wheel zooms. Esc lets go.")}function uA(n,e){let t=document.createElement("i");if(n.color&&(t.style.background=n.color),n.press){let s=Ps("button",W(n.text));return s.type="button",s.setAttribute("aria-pressed",String(n.pressed())),s.addEventListener("click",()=>{n.press(),s.setAttribute("aria-pressed",String(n.pressed())),e()}),s}let i=document.createElement(n.key?"label":"span");if(n.key){let s=document.createElement("input");Object.assign(s,{type:"checkbox",checked:Is(n)}),s.dataset.part=n.key,s.setAttribute("aria-label",W("show {part}",{part:W(n.text)})),s.addEventListener("change",()=>{Xg(n.key,s.checked),e()}),i.append(s)}return i.append(t,W(n.text)),i}function Zg(n,e){n.replaceChildren(...e.map(([t,i])=>{let s=document.createElement("div");return s.append(Ps("dt",W(t)),Ps("dd",$t(W(i)))),s}))}var mu=1e3,gu=class{constructor(e,t,i){this.roots=e,this.onChange=t,this.refuse=i,this.rows=new Map}show(e,t){let i=e.map(({key:s})=>s);if(i.join()!==this.keys){this.keys=i.join();let s=new Map(e.map(a=>[a.key,this.rows.get(a.key)??this.row(a)]));this.rows=s;let r=t.filter(a=>s.has(a)),o=i.filter(a=>!r.includes(a));jg(this.roots.first,r.map(a=>s.get(a).line)),jg(this.roots.more,o.map(a=>s.get(a).line)),this.roots.fold.hidden=!o.length}for(let s of e)this.refresh(s)}row(e){let t=document.createElement("div");t.className=e.choices?"control choice":"control";let i=document.createElement("label"),s=`set-${e.key.replaceAll(".","-")}`;i.htmlFor=s,t.append(i);let r={label:i,line:t};if(e.choices){r.choice=document.createElement("select"),r.choice.id=s;for(let[o,a]of e.choices)r.choice.append(new Option(W(a),o));r.choice.addEventListener("change",()=>this.onChange(e.key,Number(r.choice.value))),t.append(r.choice)}else r.slider=document.createElement("input"),Object.assign(r.slider,{type:"range",min:0,max:mu,step:"any"}),r.slider.addEventListener("input",()=>this.onChange(e.key,hA(r.control,Number(r.slider.value)/mu))),r.slider.addEventListener("change",()=>this.settle()),r.field=document.createElement("input"),Object.assign(r.field,{type:"text",inputMode:"decimal",id:s,autocomplete:"off"}),r.field.addEventListener("change",()=>this.typed(r)),r.unit=document.createElement("span"),t.append(r.field,r.unit,r.slider);return r}refresh(e){let t=this.rows.get(e.key),[i,s]=[W(e.label),W(e.unit??"")];if(t.label.textContent=i,t.choice){t.choice.value=String(e.value);return}let r=t.slider===document.activeElement&&t.slider.matches(":active");t.control=r?{...t.control,value:e.value}:e,t.slider.setAttribute("aria-label",i),r||(t.slider.value=String(mu*dA(e,e.value))),t.slider.style.setProperty("--part",`${100*Number(t.slider.value)/mu}%`);let o=Qd(e.value/(e.si??1));t.slider.setAttribute("aria-valuetext",`${o} ${s}`),document.activeElement!==t.field&&(t.field.value=o),t.unit.textContent=s,t.field.setAttribute("aria-label",`${i} [${s}]`),t.field.setCustomValidity(""),t.field.removeAttribute("aria-invalid")}settle(){this.onChange(null)}typed(e){let t=Number(e.field.value.trim().replace(",","."))*(e.control.si??1),{low:i,high:s,log:r,unit:o,si:a=1}=e.control,l=!e.field.value.trim()||!Number.isFinite(t)?W("A number is needed."):r&&!(t>0)?W("It must be greater than zero."):"",c=e.control.key.startsWith("body.moments")&&(t<i*.999||t>s*1.001),u=l||(c?W("No body has this moment with the two others: {least} to {most} {unit}.",{least:Qd(i/a),most:Qd(s/a),unit:o}):"");e.field.setCustomValidity(u),u?(e.field.setAttribute("aria-invalid","true"),e.field.reportValidity(),this.refuse(u)):this.onChange(e.control.key,t)}};function jg(n,e){for(let t of[...n.children])e.includes(t)||t.remove();e.forEach((t,i)=>n.children[i]!==t&&n.insertBefore(t,n.children[i]??null))}function hA({low:n,high:e,log:t,power:i=1},s){return t?n*(e/n)**s:n+(e-n)*s**i}function dA({low:n,high:e,log:t,power:i=1},s){let r=t?Math.log(Math.max(s,Number.MIN_VALUE)/n)/Math.log(e/n):((s-n)/(e-n))**(1/i);return Math.min(1,Math.max(0,Number.isFinite(r)?r:0))}function Qd(n){if(n===0)return"0";let e=Math.abs(n);return $t(e>=.001&&e<1e6?String(Number(n.toPrecision(7))):n.toExponential(5))}var hf={};ps(hf,{asSpec:()=>zE,changed:()=>BE,controls:()=>OE,event:()=>WE,facts:()=>HE,first:()=>DE,from:()=>FE,keys:()=>UE,make:()=>kE,toml:()=>VE,withSpec:()=>GE});var fA=6.283185307179586,pA=-41.341702240399755,mA=81.60524927607504,gA=-76.70585975306136,xA=42.058693944897634,yA=-15.094642576822984,_A=3.8199525848482803,vA=-.7181223017785001,MA=.10422916220813978,bA=1,SA=-19.739208802178716,wA=64.93939402266828,AA=-85.45681720669371,EA=60.24464137187664,TA=-26.426256783374388,RA=7.903536371318465,CA=-1.7143907110886711,IA=.282005968455791,PA=-.03638284114254564;function mt(n,e){let t=n*e,i=134217729*n,s=134217729*e,r=i-(i-n),o=s-(s-e),a=n-r,l=e-o;return[t,r*o-t+r*l+a*o+a*l]}function Ct(n){return n+6755399441055744-6755399441055744}function nn(n){let e=Ct(4*n),t=n-.25*e,i=t*t,s=t*(fA+i*(pA+i*(mA+i*(gA+i*(xA+i*(yA+i*(_A+i*(vA+i*MA)))))))),r=bA+i*(SA+i*(wA+i*(AA+i*(EA+i*(TA+i*(RA+i*(CA+i*(IA+i*PA)))))))),o=e-4*Math.floor(.25*e),a=o===1||o===3,{0:l,1:c}=a?[r,s]:[s,r];return[o>=2?-l:l,o===1||o===2?-c:c]}function Sn(n){let e=134217729*n,t=e-(e-n);return[t,n-t]}function ts(n,e){let{0:t,1:i,2:s}=n,{0:r,1:o,2:a}=e,l=t*r,c=t*o,u=i*r,h=Ct(l),d=Ct(c),f=Ct(u),p=i*o+s*(r+o)+(t+i)*a,{0:x,1:m}=kt(c-d,u-f),{0:g,1:y}=kt(l-h,x),v=Ct(g);return[g-v,y+(m+p),h+(d+f)+v]}function kt(n,e){let t=n+e,i=t-n;return[t,n-(t-i)+(e-i)]}function Ls(n){return mt(n,n)}function Ii(n,e){let t=n+e;return[t,e-(t-n)]}function Te(n,e){let{0:t,1:i}=kt(n[0],e[0]);return Ii(t,i+(n[1]+e[1]))}function at(n,e){return Te(n,[-e[0],-e[1]])}function xe(n,e){let{0:t,1:i}=mt(n[0],e[0]);return Ii(t,i+(n[0]*e[1]+n[1]*e[0]))}function Vn(n,e){let{0:t,1:i}=mt(n[0],e);return Ii(t,i+n[1]*e)}function wn(n){let{0:e,1:t}=mt(n[0],n[0]);return Ii(e,t+2*n[0]*n[1])}function de(n,e){return[n[0]*e,n[1]*e]}function be(n,e){let t=n[0]/e[0],{0:i,1:s}=mt(t,e[0]),r=n[0]-i-s+(n[1]-t*e[1]);return Ii(t,r/e[0])}function Ns(n){let e=Math.sqrt(n[0]),{0:t,1:i}=mt(e,e);return Ii(e,(n[0]-t-i+n[1])/(e+e))}function Yt(n){let e=n[0]===0;return e?[0,0]:Ns(e?[1,0]:n)}var Pi=[3.141592653589793,12246467991473532e-32],so=[.15915494309189535,-9839338337591243e-33],Kg=[.6931471805599453,23190468138462996e-33];var LA=1e-6,Jg=1e27,xu=n=>{let e=String(JSON.stringify(n,(t,i)=>typeof i=="number"&&!Number.isFinite(i)?String(i):i));return e.length>80?`${e.slice(0,77)}...`:e};function wt(n,e,t){if(typeof e=="number"&&Number.isFinite(e))return e;throw new RangeError(`\`${n}\` must be a finite number; got ${xu(e)}. Give it in ${t}.`)}function An(n,e,t,i){let s=e!=null&&typeof e=="object"?Array.from(e):[];if(s.length===t&&s.every(r=>typeof r=="number"&&Number.isFinite(r)))return s;throw new RangeError(`\`${n}\` must be ${t} finite numbers; got ${xu(e)}. Give them in ${i}.`)}function ro(n){let e=An("moments",n,3,"kg m\xB2");if(e.every(t=>t>0))return e;throw new RangeError(`\`moments\` must be positive; got ${xu(e)} kg m\xB2. A body with a zero moment (a thin rod) cannot spin about that axis; check values and units.`)}function oo(n){let e=An("attitude",n,4,"w, x, y, z");if(Math.abs(Math.hypot(...e)-1)<LA)return e;throw new RangeError(`\`attitude\` must be a unit quaternion w, x, y, z; got ${xu(e)}. Divide it by its norm, and check that the scalar comes first.`)}function yu(n,e,t){wt("t",n,"seconds");let[i,s]=kt(n,-e);if(Math.abs(i)*t<=Jg)return[i,s];throw new RangeError(`\`t\` less the epoch, times the rate of rotation, must be at most ${Jg} rad, beyond which a phase has hardly a digit left; got ${n} s. Check times and rates.`)}function _u(n){if(!n.every(Number.isFinite))throw new RangeError("moments, momentum or their ratios leave the range of doubles: choose other units.")}var vu=([n,e,t,i,s,r,o])=>({attitude:[n,e,t,i],momentum:[s,r,o]}),Hn=n=>Number.isNaN(n)?null:n;var NA=([n,e,t,i])=>[n,-e,-t,-i],DA=([n,e,t,i])=>Math.sqrt(n*n+e*e+t*t+i*i);function ao(n){let e=DA(n);return n.map(t=>t/e)}function Ca([n,e,t,i],[s,r,o]){let a=2*(t*o-i*r),l=2*(i*s-e*o),c=2*(e*r-t*s);return[s+n*a+(t*c-i*l),r+n*l+(i*a-e*c),o+n*c+(e*l-t*a)]}var Ds=(n,e)=>Ca(NA(n),e);var UA=[0,.05260015195876773,.0789002279381516,.1183503419072274,.2816496580927726,.3333333333333333,.25,.3076923076923077,.6512820512820513,.6,.8571428571428571,1],Qg=[[],[[0,.05260015195876773]],[[0,.0197250569845379],[1,.0591751709536137]],[[0,.02958758547680685],[2,.08876275643042054]],[[0,.2413651341592667],[2,-.8845494793282861],[3,.924834003261792]],[[0,.037037037037037035],[3,.17082860872947386],[4,.12546768756682242]],[[0,.037109375],[3,.17025221101954405],[4,.06021653898045596],[5,-.017578125]],[[0,.03709200011850479],[3,.17038392571223998],[4,.10726203044637328],[5,-.015319437748624402],[6,.008273789163814023]],[[0,.6241109587160757],[3,-3.3608926294469414],[4,-.868219346841726],[5,27.59209969944671],[6,20.154067550477894],[7,-43.48988418106996]],[[0,.47766253643826434],[3,-2.4881146199716677],[4,-.590290826836843],[5,21.230051448181193],[6,15.279233632882423],[7,-33.28821096898486],[8,-.020331201708508627]],[[0,-.9371424300859873],[3,5.186372428844064],[4,1.0914373489967295],[5,-8.149787010746927],[6,-18.52006565999696],[7,22.739487099350505],[8,2.4936055526796523],[9,-3.0467644718982196]],[[0,2.273310147516538],[3,-10.53449546673725],[4,-2.0008720582248625],[5,-17.9589318631188],[6,27.94888452941996],[7,-2.8589982771350235],[8,-8.87285693353063],[9,12.360567175794303],[10,.6433927460157636]]],FA=[[0,.054293734116568765],[5,4.450312892752409],[6,1.8915178993145003],[7,-5.801203960010585],[8,.3111643669578199],[9,-.1521609496625161],[10,.20136540080403034],[11,.04471061572777259]],OA=[[0,.01312004499419488],[5,-1.2251564463762044],[6,-.4957589496572502],[7,1.6643771824549864],[8,-.35032884874997366],[9,.3341791187130175],[10,.08192320648511571],[11,-.022355307863886294]],BA=[[0,-.18980075407240762],[5,4.450312892752409],[6,1.8915178993145003],[7,-5.801203960010585],[8,-.4226823213237919],[9,-.1521609496625161],[10,.20136540080403034],[11,.02265179219836082]],kA=.01,Mu=class{constructor(e,t){this.rates=e,this.size=t,this.stages=Qg.map(()=>new Float64Array(t)),this.inner=new Float64Array(t)}step(e,t,i,s,r=!1){let{rates:o,size:a,stages:l,inner:c}=this;r||o(e,t,l[0]);for(let u=1;u<l.length;u++)e0(Qg[u],l,t,i,c,a),o(e+UA[u]*i,c,l[u]);e0(FA,l,t,i,s,a)}error(e,t,i,s,r){let{size:o,stages:a}=this,[l,c]=[0,0];for(let u=0;u<o;u++){let h=r*(s[u]+Math.max(Math.abs(t[u]),Math.abs(i[u])));l+=(ef(OA,a,u)/h)**2,c+=(ef(BA,a,u)/h)**2}return l===0&&c===0?0:Math.abs(e)*l/Math.sqrt((l+kA*c)*o)}};function ef(n,e,t){let i=0;for(let s=0;s<n.length;s++)i+=n[s][1]*e[n[s][0]][t];return i}function e0(n,e,t,i,s,r){for(let o=0;o<r;o++)s[o]=t[o]+i*ef(n,e,o)}var zA=1e-12,GA=2e5,VA=2048,HA=16,[t0,tf,WA]=[.9,.2,8],n0=-1/8,qA=16*Number.EPSILON,XA=60,Li=class{constructor({rates:e,start:t,time:i=0,scale:s,tolerance:r=zA,project:o,stops:a={},mostSteps:l=GA}){Object.assign(this,{time:i,tolerance:r,mostSteps:l}),this.scale=Float64Array.from(s),this.project=o??(()=>{}),this.stops=Object.entries(a),this._method=new Mu((c,u,h)=>e(i+c,u,h),t.length),this._rates=e,this._begun=null,this._forward=this._chain(1,t),this._backward=this._chain(-1,t)}at(e){let t=e-this.time,i=t<0?this._backward:this._forward,s=this._before(i,Math.abs(t)),r=s.state.slice();return s===i.end||s.elapsed===t||this._step(s,t-s.elapsed,r),r}end(e=!0){let{end:t}=e?this._forward:this._backward;return t&&{time:this.time+t.elapsed,event:t.event}}_chain(e,t){let i=Float64Array.from(t),s={elapsed:0,state:i,step:e*this._firstStep(i),count:0};return{sense:e,kept:[s],spacing:HA,from:s,to:null,end:null}}_before(e,t){let{end:i}=e;if(i&&t>=Math.abs(i.elapsed))return i;let s=$A(e.kept,t);(t<Math.abs(e.from.elapsed)||s.count>e.from.count)&&([e.from,e.to]=[s,null]);for(let r=0;;r++){if(e.to??=this._advance(e,e.from),Math.abs(e.to.elapsed)>t)return e.from;if(e.to===e.end)return e.end;r>=this.mostSteps&&this._tooFar(e,t),[e.from,e.to]=[e.to,null],YA(e,e.from)}}_advance(e,t){let i=new Float64Array(t.state.length),s=t.step,r=WA;for(;;){(!(Math.abs(s)>qA*Math.abs(t.elapsed))||s===0)&&this._stuck(t),this._step(t,s,i);let o=this._method.error(s,t.state,i,this.scale,this.tolerance);if(o<=1){let a=o===0?r:Math.min(r,Math.max(tf,t0*o**n0)),l={elapsed:t.elapsed+s,state:i,step:s*a,count:t.count+1};return this._ended(e,t,l)??l}s*=o>1?Math.max(tf,t0*o**n0):tf,r=1}}_step(e,t,i){this._method.step(e.elapsed,e.state,t,i,this._begun===e),this._begun=e,this.project(i)}_ended(e,t,i){let s=(c,u)=>this.stops.find(([,h])=>!(h(this.time+c,u)>0)),r=s(i.elapsed,i.state);if(!r)return null;let o=i.state.slice(),[a,l]=[0,i.elapsed-t.elapsed];for(let c=0;c<XA;c++){let u=.5*(a+l);this._step(t,u,o);let h=s(t.elapsed+u,o);h?[l,r]=[u,h]:a=u}return this._step(t,l,o),e.end={elapsed:t.elapsed+l,state:o,step:0,count:i.count,event:r[0]},e.end}_firstStep(e){let t=new Float64Array(e.length);this._rates(this.time,e,t);let i=o=>Math.hypot(...o.map((a,l)=>a/(this.scale[l]+Math.abs(e[l])))),[s,r]=[i(e),i(t)];return s>1e-5&&r>1e-5?.01*s/r:1e-6}_tooFar(e,t){let[i,s]=[this.time+e.sense*t,this.time+e.from.elapsed];throw new RangeError(`t = ${i} s is more than ${this.mostSteps} steps away; t = ${s} s is reached, and kept. Ask again to go on, or ask for nearer times.`)}_stuck(e){throw new RangeError(`the motion cannot be followed beyond t = ${this.time+e.elapsed} s, where it changes faster than any step. Check the parameters; losses cannot be followed far backward.`)}};function $A(n,e){let[t,i]=[0,n.length];for(;i-t>1;){let s=t+i>>1;Math.abs(n[s].elapsed)<=e?t=s:i=s}return n[t]}function YA(n,e){let t=n.kept[n.kept.length-1];e.count<=t.count||e.count%n.spacing||(n.kept.push(e),!(n.kept.length<=VA)&&(n.spacing*=2,n.kept=n.kept.filter(({count:i})=>i%n.spacing===0)))}function lo({moments:n,momentum:e,attitude:t=[1,0,0,0],epoch:i=0}){return{moments:ro(n),momentum:An("momentum",e,3,"kg m\xB2/s"),attitude:ao(oo(t)),epoch:wt("epoch",i,"seconds")}}function Ia(n,e){let t=An(n,e,3,"any unit: only the direction counts"),i=Math.max(...t.map(Math.abs));if(i>0){let s=t.map(o=>o/i),r=Math.hypot(...s);return s.map(o=>o/r)}throw new RangeError(`\`${n}\` must have a direction; got [0, 0, 0]. Give three numbers that are not all 0.`)}function Zt(n,e,t,i=!1){if(wt(n,e,t)>0||i&&e===0)return e;let s=i?"not be negative":"be positive";throw new RangeError(`\`${n}\` must ${s}; got ${e}. Check its size, sign and unit, ${t}.`)}function co(n,e,t,i,s){let[r,o,a,l]=[n[0],n[1],n[2],n[3]];s[0]=-.5*(o*e+a*t+l*i),s[1]=.5*(r*e+a*i-l*t),s[2]=.5*(r*t+l*e-o*i),s[3]=.5*(r*i+o*t-a*e)}function uo(n){let e=Math.sqrt(n[0]**2+n[1]**2+n[2]**2+n[3]**2);for(let t=0;t<4;t++)n[t]/=e}var ho=n=>Array.from(n.subarray(0,4)),fo=n=>Array.from(n.subarray(4,7)),At=(n,e)=>n[0]*e[0]+n[1]*e[1]+n[2]*e[2],bu=(n,e)=>[n[1]*e[2]-n[2]*e[1],n[2]*e[0]-n[0]*e[2],n[0]*e[1]-n[1]*e[0]],Su=(n,e)=>({"|L|\xB2":At(e,e),momentum_space:Ca(n,e)}),po=(n,e=[])=>[1,1,1,1,n,n,n,...e];var ZA=6,jA=1,KA=9,wu=class{constructor({mean_motion:e,eccentricity:t=0,mean_anomaly_at_start:i=0}){if(this.meanMotion=Zt("mean_motion",e,"rad/s"),this.eccentricity=Zt("eccentricity",t,"1",!0),!(this.eccentricity<1))throw new RangeError(`\`eccentricity\` must be below 1; got ${t}. Only ellipses come round again.`);this.meanAnomalyAtStart=wt("mean_anomaly_at_start",i,"rad")}place(e){let t=this.meanMotion*e+this.meanAnomalyAtStart,i=this.eccentricity,s=.5*JA(t-2*Math.PI*Math.round(t/(2*Math.PI)),i),[r,o]=[Math.sin(s),Math.cos(s)],a=1-i+2*i*r*r;return[(1-i-2*r*r)/a,2*Math.sqrt((1-i)*(1+i))*r*o/a,a]}};function JA(n,e){let t=Math.abs(n),i=Math.min(t+e,t/(1-e),e>0?Math.cbrt(Math.PI**2*t/e):1/0,Math.PI);for(let s=0;s<ZA;s++){let r=1-e+2*e*Math.sin(.5*i)**2;i-=((1-e)*i-t+e*QA(i))/r}return i=Math.min(Math.max(i,0),Math.PI),n<0?-i:i}function QA(n){if(n>=jA)return n-Math.sin(n);let e=n**3/6,t=0;for(let i=1;i<=KA;i++)t+=e,e*=-(n*n)/((2*i+2)*(2*i+3));return t}var eE=1e-14,Pa=class{constructor({moments:e,rate:t=0,linear_drag:i=0,quadratic_drag:s=0,orbit:r=null,momentum:o,attitude:a,epoch:l}){let c=lo({moments:e,momentum:o,attitude:a,epoch:l});this.moments=c.moments,this.epoch=c.epoch,this.rate=Zt("rate",t,"s/(kg m\xB2)",!0);let u=typeof i=="number"?[i,i,i]:i;this.linearDrag=An("linear_drag",u,3,"N m s").map(h=>Zt("linear_drag",h,"N m s",!0)),this.quadraticDrag=Zt("quadratic_drag",s,"N m s\xB2",!0),this.orbit=r===null?null:new wu(r),this.torqued=this.orbit!==null||this.quadraticDrag>0||this.linearDrag.some(h=>h>0),this._balanced=this.torqued?["kinetic_energy","|L|\xB2"]:this.rate>0?["energy"]:[],this.orbit?.eccentricity===0&&this._balanced.push("jacobi_integral"),this._motion=new Li({rates:this._rates(),start:[...c.attitude,...c.momentum,...this._balanced.map(()=>0)],time:this.epoch,scale:this._scales(c.momentum),tolerance:eE,project:uo})}_scales(e){let t=Math.max(...this.moments),i=Math.max(Math.hypot(...e),this.orbit?t*this.orbit.meanMotion:0)||t,s=this._balanced.map(r=>r==="|L|\xB2"?i*i:i*i/t);return po(i,s)}_rates(){return(e,t,i)=>{let s=this._at(e,[t[0],t[1],t[2],t[3]],[t[4],t[5],t[6]]),{momentum:r,velocity:o,drift:a,torque:l}=s,c=[o[0]+a[0],o[1]+a[1],o[2]+a[2]];co(t,c[0],c[1],c[2],i);let u=bu(r,c);for(let h=0;h<3;h++)i[4+h]=u[h]+l[h];this._balanced.forEach((h,d)=>i[7+d]=this._power(h,s))}}_at(e,t,i){let s=[0,1,2].map(u=>i[u]/this.moments[u]),r=bu(i,s),o=r.map(u=>this.rate*u),a=this.orbit?this._gravity(e,t):[0,0,0],l=this.quadraticDrag*Math.hypot(s[0],s[1],s[2]),c=[0,1,2].map(u=>a[u]-(this.linearDrag[u]+l)*s[u]);return{attitude:t,momentum:i,velocity:s,torqueless:r,drift:o,pull:a,torque:c}}_gravity(e,t){let[i,s,r]=this.orbit.place(e),o=Ds(t,[i,s,0]),a=bu(o,o.map((c,u)=>this.moments[u]*c)),l=3*this.orbit.meanMotion**2/r**3;return a.map(c=>l*c)}_relative(e,t){let i=Ds(e,[0,0,1]);return t.map((s,r)=>s-this.orbit.meanMotion*i[r])}_power(e,{attitude:t,momentum:i,velocity:s,torqueless:r,drift:o,pull:a,torque:l}){let c=-At(o,r);if(e==="|L|\xB2")return 2*At(l,i);if(e!=="jacobi_integral")return At(l,s)+c;let u=l.map((h,d)=>h-a[d]);return At(u,this._relative(t,s))+c-At(a,o)}_jacobiIntegral(e,t,i){let[s,r]=this.orbit.place(e),[o,a]=[Ds(t,[s,r,0]),Ds(t,[0,0,1])],l=this._relative(t,i),c=this.orbit.meanMotion**2,u=l.map((h,d)=>h*h+c*(3*o[d]**2-a[d]**2));return .5*At(this.moments,u)}state(e){let t=this._motion.at(wt("t",e,"seconds")),[i,s]=[ho(t),fo(t)],r=s.map((h,d)=>h/this.moments[d]),o=.5*At(s,r),a={energy:o,kinetic_energy:o,"|L|\xB2":At(s,s)};this.orbit&&(a.jacobi_integral=this._jacobiIntegral(e,i,r));let l=this._balanced.map((h,d)=>[h,{value:a[h],received:t[7+d]}]),c=this.torqued?{}:Su(i,s),u=this.torqued||this.rate>0?c:{energy:o,...c};return{attitude:i,momentum:s,velocity:r,energy:o,invariants:u,balances:Object.fromEntries(l),angleToMajorAxis:this._angleToMajorAxis(s)}}_angleToMajorAxis(e){if(!(Math.hypot(...e)>0))return null;let t=Math.max(...this.moments),i=e.map((s,r)=>this.moments[r]===t?s:0);return Math.atan2(Math.hypot(...e.map((s,r)=>s-i[r])),Math.hypot(...i))}};var tE=30,nf={"air-layer":["viscosity","Pa s",!1,(n,{g:e,a:t},i)=>Math.PI*n*e*t*t/(i*i)],"boundary-layer":["coefficient","W s^(5/2)",!1,(n,e,t,i)=>n*i*i*Math.sqrt(i)],"viscous-contour-friction":["coefficient","W s\xB2",!1,(n,e,t,i)=>n*i*i],"dry-contour-friction":["coefficient","1",!1,(n,{m:e,g:t,a:i},s,r)=>n*e*t*i*r],"rolling-couple":["arm","m",!1,(n,{m:e,g:t},i,s)=>n*e*t*s*Math.sin(i)],"drilling-friction":["arm","m",!0,(n,{m:e,g:t},i,s)=>n*e*t*s*i*i]};function i0(n){if(!Array.isArray(n))throw new RangeError('`dissipation` must be a list of laws, like [{law: "air-layer", viscosity: 1.8e-5}].');return n.map((e,t)=>{let i=e!==null&&typeof e=="object"&&Object.hasOwn(nf,e.law)&&nf[e.law];if(!i){let c=Object.keys(nf).join(", ");throw new RangeError(`\`dissipation[${t}].law\` must be one of ${c}; got ${JSON.stringify(e?.law)}.`)}let[s,r,o,a]=i,l=Zt(`dissipation[${t}].${s}`,e[s],r);return{vertical:o,power:(c,u,h)=>a(l,c,u,h)}})}function Au(n,e,t,i,s){let[r,o]=[0,0],[a,l]=[Math.sin(t),Math.cos(t)],c=Math.abs(a),[u,h]=[Math.min(t,Math.PI-t),Math.abs(i)/c];for(let d of e){let[f,p]=d.vertical?[a,l]:[-l/a,1],x=f*i+p*s,m=n.accelerations(f,p),g=tE*Math.sqrt(n.g/(n.a*c))/(f*m[0]+p*m[1]),y=d.power(n,u,h),v=y>=g*x*x?-x*g:-y/x;r+=f*v,o+=p*v}return[r,o]}var nE=.5772156649015329,Eu=class{constructor(e){let t=iE(e);[this.near,this.far]=[[1],[]];let i=-nE;for(let o=0;o<64;o++)this.far.push(this.near[o]*(2*i-t[o])),this.near.push(this.near[o]*(o*(o+1)+e)/(o+1)**2),i+=1/(o+1);this.near.pop();let s=.25-e,r=Math.PI*Math.sqrt(Math.abs(s));this.sine=(s<0?Math.cosh(r):Math.cos(r))/Math.PI}values(e){let t=Math.sin(.5*e)**2,i=.5*Math.sin(e);if(t<=.5){let[u,h]=sf(this.near,t);return[u,i*h]}let s=Math.cos(.5*e)**2,r=Math.log(s),[o,a]=sf(this.near,s),[l,c]=sf(this.far,s);return[this.sine*(l-r*o),-i*this.sine*(c-r*a-o/s)]}};function s0(n,{m:e,a:t,C:i},s,r,o){let[a,l]=n.values(s),[c,u]=n.values(Math.PI-s),h=e*t*t*r/(i+e*t*t),d=-2*n.sine/Math.sin(s);return[(-u*o-c*h)/d,(a*h-l*o)/d]}function iE(n){let e=.25-n,t=new Array(65),i=64,[s,r]=e>=0?[Math.sqrt(e),0]:[0,Math.sqrt(-e)];t[64]=[1,-1].reduce((o,a)=>{let[l,c]=[Math.hypot(i+a*s,r),Math.atan2(a*r,i+a*s)],u=h=>Math.cos(h*c)/l**h;return o+Math.log(l)+u(2)/24-7*u(4)/960+31*u(6)/8064-127*u(8)/30720},0);for(let o=63;o>=0;o--)t[o]=t[o+1]-(2*o+1)/(o*(o+1)+n);return t}function sf(n,e){let[t,i]=[0,0];for(let s=n.length-1;s>=0;s--)i=t+e*i,t=n[s]+e*t;return[t,i]}var Tu=class{constructor({m:e,a:t,b:i,A:s,C:r,g:o}){Object.assign(this,{m:e,a:t,b:i,A:s,C:r,g:o})}tiltAcceleration(e,t,i){let{m:s,a:r,b:o,A:a,C:l,g:c}=this,[u,h]=[Math.sin(e),Math.cos(e)];return((a+s*o*o)*t*t*h/u+s*r*o*t*(t-i*h/u)-(l+s*r*r)*t*i-s*c*(r*h-o*u))/(a+s*r*r+s*o*o)}tiltDerivatives(e,t,i){let{m:s,a:r,b:o,A:a,C:l,g:c}=this,[u,h]=[Math.sin(e),Math.cos(e)],[d,f,p]=[a+s*o*o,l+s*r*r,s*r*o],x=a+s*r*r+s*o*o,m=(p*t*i-d*t*t)/(u*u)+s*c*(r*u+o*h),g=2*d*t*h/u+2*p*t-p*i*h/u-f*i,y=-p*t*h/u-f*t;return[m/x,g/x,y/x]}transport(e,t,i){let{m:s,a:r,b:o,A:a,C:l}=this,c=Math.cos(e)/Math.sin(e);return this.accelerations(l*i-(a+s*o*o)*t*c-s*r*o*t,s*r*(r+o*c)*t)}accelerations(e,t){let{m:i,a:s,b:r,A:o,C:a}=this,[l,c,u]=[o+i*r*r,a+i*s*s,i*s*r],h=o*a+i*s*s*o+i*r*r*a;return[(c*e+u*t)/h,(u*e+l*t)/h]}energy(e,t,i,s){let{m:r,a:o,b:a,A:l,C:c,g:u}=this,h=(a*i-o*s)**2+(o*o+a*a)*t*t,d=o*Math.sin(e)-2*a*Math.sin(.5*e)**2;return .5*(l*(t*t+i*i)+c*s*s+r*h)+r*u*d}normalForce(e,t,i,s){let{m:r,a:o,b:a,g:l}=this,[c,u]=[Math.sin(e),Math.cos(e)];return r*(l+(o*u-a*c)*this.tiltAcceleration(e,i,s)-(o*c+a*u)*t*t)}};var sE=1e-9;function r0(n,e,t,i){let{m:s,a:r,b:o,A:a,C:l,g:c}=n,[u,h]=[Math.sin(e),Math.cos(e)],d=s*c*(r*h-o*u),[f,p]=[t,i];if(f===null){if(f=Math.sqrt(d/(a*u*h-l*u*u*o/r)),!Number.isFinite(f)||!(f>0))throw new RangeError(`no steady motion has its centre at rest at tilt ${e} rad. Give \`precession\`.`);p??=f*u*o/r}let x=wt("precession",f,"rad/s")*u;if(p??=(((a+s*o*o)*h+s*r*o*u)*u*f**2-d)/(((l+s*r*r)*u+s*r*o*h)*f),!Number.isFinite(p))throw new RangeError("`spin` must be given where nothing precesses, as in straight rolling.");let m=n.tiltAcceleration(e,x,p);if(Math.abs(m)<=sE*(c/r+x*x+p*p))return[x,p];throw new RangeError(`tilt ${e} rad, \`precession\` ${f} and \`spin\` ${p} rad/s are not steady: the tilt would accelerate by ${m} rad/s\xB2. Give one of the rates only.`)}function o0(n,e,t,i,s){if(!e.length)return 0;let[r,o,a]=n.tiltDerivatives(t,i,s),[l,c]=n.transport(t,i,s),u=-(r+o*l+a*c);if(!(u>0))throw new RangeError(`the steady motion at tilt ${t} rad is unstable: no slow manifold to start on. Give another tilt.`);let[h,d]=n.accelerations(...Au(n,e,t,i,s));return(o*h+a*d)/u}var rE=1e-14,rf=1e-6,oE=.001,aE=9.80665,a0=["tilt","heading","face","contact_x","contact_y","tilt_rate","rise_rate","spin"],mo=class{constructor({start:e,epoch:t=0,...i}){let{disk:s,laws:r}=l0(i),{m:o,a,b:l,A:c,C:u,g:h}=s;this.moments=[c,c,u],this.onPlane=!0,[this.radius,this.halfThickness]=[a,l],this.epoch=wt("epoch",t,"seconds"),this.thin=l===0,[this._disk,this._laws]=[s,r],this._legendre=this.thin&&!r.length?new Eu(o*a*a*u/(c*(u+o*a*a))):null;let d=Math.sqrt(h/a);this._motion=new Li({rates:this._rates(),start:[...lE(e,this.thin),0],time:this.epoch,scale:[oE,1,1,a,a,d,d,d,o*h*a],tolerance:rE,stops:this._stops(o*h)})}static rollingStart({tilt:e,precession:t=null,spin:i=null,heading:s=0,face:r=0,...o}){let{disk:a,laws:l}=l0(o);c0(wt("tilt",e,"rad"),a.b===0);let c=r0(a,e,t,i);return[e,s,r,0,0,o0(a,l,e,...c),...c]}_stops(e){let t={flat:(i,s)=>Math.sin(s[0])-rf,"lift-off":(i,s)=>this._disk.normalForce(s[0],s[5],s[6],s[7])/e};return this.thin?t:{...t,"on edge":(i,s)=>Math.cos(s[0])}}_rates(){let[e,t]=[this._disk,this._laws];return(i,s,r)=>{let[o,a,l,c,u]=[s[0],s[1],s[5],s[6],s[7]],h=c/Math.sin(o),d=u-h*Math.cos(o),[f,p]=Au(e,t,o,c,u),[x,m]=e.accelerations(f,p),[g,y]=e.transport(o,c,u);r[0]=l,r[1]=h,r[2]=u+2*h*Math.sin(.5*o)**2,r[3]=-e.a*d*Math.cos(a),r[4]=-e.a*d*Math.sin(a),r[5]=e.tiltAcceleration(o,c,u),r[6]=g*l+x,r[7]=y*l+m,r[8]=f*c+p*u}}get end(){return this._motion.end()}state(e){let t=wt("t",e,"seconds"),[i,s,r,o,a,l,c,u,h]=this._motion.at(t),d=this._disk,[f,p]=[Math.sin(i),Math.cos(i)],[x,m,g]=[-Math.sin(s),Math.cos(s),d.b],y=r-s,v=[Math.cos(y)*l+Math.sin(y)*c,Math.cos(y)*c-Math.sin(y)*l,u],M=d.energy(i,l,c,u),w=this._motion.end(e>=this.epoch);return{attitude:cE(i,s,r),momentum:v.map((E,_)=>this.moments[_]*E),velocity:v,energy:M,tilt:i,heading:s,face:r,invariants:this._invariants(M,i,c,u),balances:this._laws.length?{energy:{value:M,received:h}}:{},contact:[o,a],center:[o+x*(d.a*p-g*f),a+m*(d.a*p-g*f),d.a*f+g*p],normalForce:d.normalForce(i,l,c,u),parts:[i,s,r,o,a,l,c,u],ended:w&&Math.abs(e-this.epoch)>=Math.abs(w.time-this.epoch)?w.event:null}}_invariants(e,t,i,s){if(this._laws.length)return{};if(!this._legendre)return{energy:e};let[r,o]=s0(this._legendre,this._disk,t,i,s);return{energy:e,linear_integral_1:r,linear_integral_2:o}}};function l0({mass:n,radius:e,half_thickness:t=0,axial_moment:i,diametral_moment:s,gravity:r=aE,dissipation:o=[]}){let[a,l,c]=[Zt("mass",n,"kg"),Zt("radius",e,"m"),Zt("gravity",r,"m/s\xB2")],u=Zt("half_thickness",t,"m",!0);if(u>l)throw new RangeError(`\`half_thickness\` must be at most the radius, ${l} m; got ${u}. Check units.`);let h=Zt("axial_moment",i??.5*a*l*l,"kg m\xB2"),d=Zt("diametral_moment",s??a*(.25*l*l+u*u/3),"kg m\xB2");if(h>2*d*(1+1e-12))throw new RangeError(`\`axial_moment\` must be at most twice \`diametral_moment\`; got ${h} and ${d} kg m\xB2. Check units.`);return{disk:new Tu({m:a,a:l,b:u,A:d,C:h,g:c}),laws:i0(o)}}function lE(n,e){let t=An("start",n,a0.length,`SI units: ${a0.join(", ")}`);return c0(t[0],e),t}function c0(n,e){let t=e?Math.PI:.5*Math.PI;if(!(n>0&&n<t&&Math.sin(n)>rf))throw new RangeError(`the tilt at the start must lie between ${rf} rad and ${e?"\u03C0 less that":"\u03C0/2 for a thick disk"}; got ${n} rad. A disk that lies flat does not roll: start at a small tilt, such as 0.1.`)}function cE(n,e,t){let[i,s]=[Math.sin(.5*n),Math.cos(.5*n)],[r,o]=[.5*t,e-.5*t];return[s*Math.cos(r),i*Math.cos(o),i*Math.sin(o),s*Math.sin(r)]}var uE=1e-14,La=class{constructor({moments:e,rotor:t,rotor_moment:i=null,rotor_drive:s="constant-rate",axis:r=null,momentum:o,attitude:a,epoch:l}){let c=lo({moments:e,momentum:o,attitude:a,epoch:l});if(this.moments=c.moments,this.epoch=c.epoch,this.rotor=An("rotor",t,3,"kg m\xB2/s"),this.rotorMoment=i===null?null:Zt("rotor_moment",i,"kg m\xB2"),!["constant-rate","free"].includes(s))throw new RangeError(`\`rotor_drive\` must be "constant-rate" or "free"; got ${JSON.stringify(s)}.`);this.free=s==="free";let u=Math.hypot(...this.rotor)>0;this.axis=r===null?u&&Ia("rotor",this.rotor):Ia("axis",r);let h=Math.max(Math.hypot(...c.momentum),Math.hypot(...this.rotor))||Math.max(...this.moments);this._motion=new Li({rates:this._rates(),start:[...c.attitude,...c.momentum],time:this.epoch,scale:po(h),tolerance:uE,project:uo})}_rates(){let[e,t,i]=this.moments,[s,r,o]=this.rotor;return(a,l,c)=>{let[u,h,d]=[l[4],l[5],l[6]],[f,p,x]=[(u-s)/e,(h-r)/t,(d-o)/i];co(l,f,p,x,c),c[4]=h*x-d*p,c[5]=d*f-u*x,c[6]=u*p-h*f}}state(e){let t=this._motion.at(wt("t",e,"seconds")),[i,s]=[ho(t),fo(t)],r=s.map((c,u)=>c-this.rotor[u]),o=r.map((c,u)=>c/this.moments[u]),a=.5*At(r,o),l={energy:a,...Su(i,s)};return{attitude:i,momentum:s,velocity:o,energy:a,invariants:l,rotorRate:this.rotorRate(o)}}rotorRate(e){return this.rotorMoment===null||!this.axis?null:At(this.rotor,this.axis)/this.rotorMoment-(this.free?At(e,this.axis):0)}};var go=1e-12,hE=1e-12;function u0(n,e,t,i){if(e===0)return["Euler's |\u03A0|\xB2",s=>At(s,s)];if(dE(n,t))return["Lagrange's \u03A0\xB7\u03C7",s=>At(s,t)];for(let s=0;s<3;s++){let[r,o]=h0(s);if(!d0(n[r],n[o])||Math.abs(t[s])>go)continue;let a={moments:n,axis:t,i:r,j:o,k:s,strength:e/n[s]};if(Math.abs(n[r]/2-n[s])<=go*n[s])return["Kovalevskaya's integral",pE(a)];if(Math.abs(n[r]/4-n[s])<=go*n[s])return["Goryachev and Chaplygin's integral",fE(...i)?mE(a):()=>NaN]}return null}var h0=n=>[(n+1)%3,(n+2)%3],d0=(n,e)=>Math.abs(n-e)<=go*n;function dE(n,e){let t=Math.max(...n);return t-Math.min(...n)<=go*t?!0:[0,1,2].some(i=>{let[s,r]=h0(i);return d0(n[s],n[r])&&Math.abs(e[s])+Math.abs(e[r])<=go})}var fE=(n,e)=>Math.abs(At(n,e))<=hE*Math.hypot(...n)*Math.hypot(...e);function pE({moments:n,axis:e,i:t,j:i,strength:s}){return(r,o)=>{let[a,l]=[r[t]/n[t],r[i]/n[i]],c=a*a-l*l-s*(o[t]*e[t]-o[i]*e[i]),u=2*a*l-s*(o[t]*e[i]+o[i]*e[t]);return c*c+u*u}}function mE({moments:n,axis:e,i:t,j:i,k:s,strength:r}){return(o,a)=>{let l=o.map((c,u)=>c/n[u]);return l[s]*(l[t]**2+l[i]**2)-r*At(l,e)*a[s]}}var gE=1e-14,Na=class{constructor({moments:e,mgl:t,axis:i=[0,0,1],momentum:s,attitude:r,epoch:o}){let a=lo({moments:e,momentum:s,attitude:r,epoch:o});this.moments=a.moments,this.epoch=a.epoch,this.mgl=wt("mgl",t,"N m"),this.axis=Ia("axis",i);let l=Ds(a.attitude,[0,0,1]);this._third=u0(this.moments,this.mgl,this.axis,[a.momentum,l]);let c=Math.max(...this.moments),u=Math.max(Math.hypot(...a.momentum),Math.sqrt(Math.abs(this.mgl)*c))||c;this._motion=new Li({rates:this._rates(),start:[...a.attitude,...a.momentum],time:this.epoch,scale:po(u),tolerance:gE,project:uo})}_rates(){let[e,t,i]=this.moments,[s,r,o]=this.axis.map(a=>this.mgl*a);return(a,l,c)=>{let[u,h,d,f]=[l[0],l[1],l[2],l[3]],[p,x,m]=[l[4],l[5],l[6]],[g,y,v]=[p/e,x/t,m/i];co(l,g,y,v,c);let[M,w,E]=[2*(h*f-u*d),2*(d*f+u*h),u*u-h*h-d*d+f*f];c[4]=x*v-m*y+w*o-E*r,c[5]=m*g-p*v+E*s-M*o,c[6]=p*y-x*g+M*r-w*s}}state(e){let t=this._motion.at(wt("t",e,"seconds")),[i,s]=[ho(t),fo(t)],r=s.map((c,u)=>c/this.moments[u]),o=Ds(i,[0,0,1]),a=.5*At(s,r)+this.mgl*At(o,this.axis),l={energy:a,"|P|\xB2":At(o,o),"\u03A0\xB7P":At(s,o)};return this._third&&(l[this._third[0]]=this._third[1](s,o)),{attitude:i,momentum:s,velocity:r,energy:a,invariants:l}}};var Da=2*Math.PI,xE=[.08,.25,.5,.75],yE=2400,of=160,_E=.05,si=n=>[0,1,2].sort((e,t)=>n[e]-n[t]||e-t);function vE(n){let[e,t,i]=si(n);return n[e]<n[t]&&n[t]<n[i]}function ur(n,e,t=yE){let i=si(n),[s,r,o]=i.map(y=>n[y]),[a,l,c]=i.map(y=>e[y]/Math.hypot(...e));if(s===o)return null;let u=s*(o-r)*c*c-o*(r-s)*a*a;if(u===0&&s<r&&r<o)return null;let h=u>0,d=h?s*(o-r)/(r*(o-s)):o*(r-s)/(r*(o-s)),f=h?a:c,p=Math.sqrt(l*l+(d>0?f*f/d:0)),x=Math.sqrt(f*f+d*l*l);if(x===0||!(p<=1+1e-12))return null;let m=Math.sign(h?c:a)||1,g=[];for(let y of ME(Math.min(p,1),t)){let[v,M]=[x*Math.cos(y),p*Math.sin(y)],w=m*Math.sqrt(Math.max(0,1-v*v-M*M)),E=[0,0,0];[E[i[0]],E[i[1]],E[i[2]]]=h?[v,M,w]:[w,M,v],g.push(...E)}return g}function ME(n,e){let t=[];for(let s=0;s<e;s++)t.push(Da*s/e);let i=Math.sqrt(Math.max(0,1-n*n));for(let s=.02*i;i>0&&s<.5;s+=_E*Math.max(s,.4*i)){let r=Math.asin(s);for(let o of[.25*Da,.75*Da])t.push(o-r,o+r)}return t.push(Da),t.sort((s,r)=>s-r)}function p0(n){let e=si(n),[t,i,s]=e.map(o=>n[o]);if(t===s)return[];let r=[t<i,t===s,i<s];return e.flatMap((o,a)=>[1,-1].map(l=>{let c=[0,0,0];return c[o]=l,{at:c,verdict:r[a]?"stable":"unstable"}}))}function m0(n){let e=si(n),[t,i,s]=e.map(a=>n[a]),r=[];if(t===s)return r;let o=Math.atan2(Math.sqrt((s-i)*t),Math.sqrt((i-t)*s));for(let[a,l,c]of[[e[2],e[0],o],[e[0],e[2],.5*Math.PI-o]])if(!(c<1e-9))for(let u of xE){let h=[0,0,0];[h[a],h[l]]=[Math.cos(u*c),Math.sin(u*c)],r.push(...Ua(n,h))}return r}function Ua(n,e){let t=ur(n,e,of);return t?[...af(t),...af(t.map(i=>-i))]:[]}function g0(n){if(!vE(n))return[];let e=si(n),[t,i,s]=e.map(a=>n[a]),r=Math.atan2(Math.sqrt((s-i)*t),Math.sqrt((i-t)*s)),o=[];for(let a of[1,-1]){let l=[];for(let c=0;c<=of;c++){let u=[0,0,0],h=Da*c/of;u[e[1]]=Math.cos(h),u[e[0]]=a*Math.sin(h)*Math.sin(r),u[e[2]]=Math.sin(h)*Math.cos(r),l.push(...u)}o.push(...af(l))}return o}var Ni=64,f0=9;function x0(n,e,t){if(!(t>0))return[];let i=l=>l.reduce((c,u,h)=>c+(t*u-e[h])**2/n[h],0),s=[],[r,o]=[1/0,-1/0];for(let l=0;l<6;l++){let c=[];for(let u=0;u<=Ni;u++)for(let h=0;h<=Ni;h++){let d=[0,0,0];d[l%3]=l<3?1:-1,d[(l+1)%3]=Math.tan((2*u/Ni-1)*.25*Math.PI),d[(l+2)%3]=Math.tan((2*h/Ni-1)*.25*Math.PI);let f=Math.hypot(...d),p=d.map(m=>m/f),x=i(p);[r,o]=[Math.min(r,x),Math.max(o,x)],c.push([p,x])}s.push(c)}let a=[];if(!(o-r>1e-12*Math.abs(o)))return a;for(let l of s)for(let c=0;c<Ni;c++)for(let u=0;u<Ni;u++){let[h,d,f,p]=[l[c*(Ni+1)+u],l[(c+1)*(Ni+1)+u],l[(c+1)*(Ni+1)+u+1],l[c*(Ni+1)+u+1]];for(let x of[[h,d,f],[h,f,p]])bE(x,r,o,a)}return a}function bE(n,e,t,i){let s=n.map(([,l])=>l),r=(t-e)/(f0+1),o=Math.max(1,Math.ceil((Math.min(...s)-e)/r)),a=Math.min(f0,Math.floor((Math.max(...s)-e)/r));for(let l=o;l<=a;l++){let c=e+l*r,u=[];for(let h=0;h<3;h++){let[[d,f],[p,x]]=[n[h],n[(h+1)%3]];if(f<c==x<c)continue;let m=(c-f)/(x-f),g=d.map((v,M)=>v+m*(p[M]-v)),y=Math.hypot(...g);u.push(g.map(v=>v/y))}u.length===2&&i.push(...u[0],...u[1])}}function af(n){let e=[];for(let t=0;t+5<n.length;t+=3)e.push(...n.slice(t,t+6));return e}var lf={"-":"\u207B",0:"\u2070",1:"\xB9",2:"\xB2",3:"\xB3",4:"\u2074",5:"\u2075",6:"\u2076",7:"\u2077",8:"\u2078",9:"\u2079"};function et(n,e=6){if(n===0)return"0";if(!Number.isFinite(n))return"\u2014";let t=Math.abs(n);if(t>=.001&&t<1e6){let o=t>=10**e?String(Number(n.toPrecision(e))):n.toPrecision(e);return $t(o.replace("-","\u2212"))}let[i,s]=n.toExponential(e-1).split("e"),r=[...s.replace("+","")].map(o=>lf[o]).join("");return $t(`${i}\xB710${r}`.replace("-","\u2212"))}var SE=[[31557600,"yr"],[86400,"d"],[3600,"h"],[60,"min"]],wE=[[1,"s"],[.001,"ms"],[1e-6,"\xB5s"],[1e-9,"ns"],[1e-12,"ps"],[1e-15,"fs"]];function cf(n){return SE.find(([e])=>n>=3*e)??wE.find(([e])=>n>=.3*e)??null}function En(n,e){let[t,i]=cf(e)??[null];return t?`${$t((n/t).toFixed(AE(e/t)))} ${W(i)}`:`${et(n,4)} s`}var Mt=(n,e)=>$t(n.toPrecision(e)),Ru=(n,e)=>W("{least} to {most}",{least:y0(n),most:y0(e)}),y0=n=>`${et(n*180/Math.PI,4)}\xB0`,xi=(n,e=4)=>W("{number} rpm",{number:et(n*30/Math.PI,e)}),AE=n=>Math.max(0,Math.min(4,4-Math.ceil(Math.log10(Math.max(n,1e-9))))),He=n=>String(n);var uf=Math.PI/30,_0=Math.PI/180;function sn(n,e){let[t,i,s]=[0,1,2].map(r=>n[(e+r)%3]);return{rate:Math.hypot(...n),tilt:Math.atan2(Math.hypot(i,s),t),around:i||s?Math.atan2(s,i):0}}function b0(n,{rate:e,tilt:t,around:i}){let s=[0,0,0];return s[n]=e*Math.cos(t),s[(n+1)%3]=e*Math.sin(t)*Math.cos(i),s[(n+2)%3]=e*Math.sin(t)*Math.sin(i),s}var Us={rate:1,about:1,tilt:1,angular_velocity:3,momentum:3,attitude:4},Wn=(n,e)=>`[${n.map(t=>`"${He(t)} ${e}"`).join(", ")}]`,Fs=n=>n.map(Math.abs).reduce((e,t,i,s)=>t>s[e]?i:e,0),Os=n=>n.map((e,t)=>({key:`body.moments.${t}`,label:W("moment of inertia I{axis}",{axis:"\u2081\u2082\u2083"[t]}),unit:"kg m\xB2",value:e,...EE(n,t)}));function EE(n,e){let[t,i]=[n[(e+1)%3],n[(e+2)%3]],[s,r]=[Math.abs(t-i),t+i];return{low:Math.max(s,.001*r),high:r,log:!0}}function Bs({velocity:n,about:e,around:t}){let{rate:i,tilt:s}=sn(n,e),r=i<.001*uf||i>1e6*uf;return[{key:"spin.rate",label:"spin rate |\u03A9|",unit:r?"rad/s":"rpm",si:r?1:uf,value:i,log:!0,low:i/20||.1,high:20*i||100},{key:"spin.about",label:"tilt counted from",value:e,choices:[0,1,2].map(o=>[o,W("axis {axis}",{axis:o+1})])},{key:"spin.tilt",label:"tilt of the spin",unit:"\xB0",si:_0,value:s,low:0,high:Math.PI,power:2},{key:"spin.around",label:W("tilted towards (0\xB0 is axis {axis})",{axis:(e+1)%3+1}),unit:"\xB0",si:_0,value:s>0?sn(n,e).around:t,low:-Math.PI,high:Math.PI}]}function ks(n,e,t){let[,i,s]=e.split(".");if(i==="moments"){let o=n.moments.map((a,l)=>l===Number(s)?t:a);return{...n,moments:o,momentum:null}}if(i==="about")return{...n,about:t,around:sn(n.velocity,t).around};let r={...sn(n.velocity,n.about)};return r.tilt>0||(r.around=n.around),r[i]=t,{...n,velocity:b0(n.about,r),around:r.around,momentum:null}}function zs(n,{body:e={},spin:t={}},i=[0,0,0]){let s={...n};if(e.moments&&(s={...s,moments:RE(e.moments),momentum:null}),t.attitude&&(s.attitude=t.attitude.map(Number)),t.momentum){let d=t.momentum.map(Number),f=d.map((p,x)=>(p-i[x])/s.moments[x]);return{...s,momentum:d,velocity:f,around:sn(f,s.about).around}}if(t.angular_velocity){let d=t.angular_velocity.map(Number);return{...s,momentum:null,velocity:d,around:sn(d,s.about).around}}if(["rate","about","tilt"].every(d=>t[d]===void 0))return s;if(t.about!==void 0&&![1,2,3].includes(t.about))throw new RangeError(`spin.about must be 1, 2 or 3, a principal axis; got ${t.about}.`);let r=TE(s.moments),o=t.about===void 0?r.findIndex(d=>d[s.about]!==0):t.about-1,a=sn(r.map(d=>S0(d,s.velocity)),o),l={rate:t.rate??a.rate,tilt:t.tilt??a.tilt,around:t.tilt===void 0?a.around:0},c=b0(o,l),u=[0,1,2].map(d=>r.reduce((f,p,x)=>f+p[d]*c[x],0)),h=r[o].findIndex(d=>d!==0);return{...s,about:h,around:sn(u,h).around,momentum:null,velocity:u}}var S0=(n,e)=>n.reduce((t,i,s)=>t+i*e[s],0);function TE(n){let e=si(n),t=(e[1]-e[0])*(e[2]-e[0])*(e[2]-e[1])<0;return e.map((i,s)=>[0,1,2].map(r=>r===i?t&&s===2?-1:1:0))}function RE(n){let e=n[0]+n[1]+n[2];if(n.every(t=>t>0&&2*t<=e*(1+1e-9)))return n;throw new RangeError(`Moments must be positive and satisfy I1 + I2 \u2265 I3; got ${n.join(", ")} kg m\xB2. No rigid body has these.`)}var ri=({moments:n,velocity:e,momentum:t},i=[0,0,0])=>t??e.map((s,r)=>s*n[r]+i[r]),[CE,v0]=[60,24];function Cu(n,e,t=[0,0,1]){let i=n.state(n.epoch),s=2*Math.PI/(Math.hypot(...i.velocity)||1)/v0,[r,o]=PE(t),[a,l]=[[],[]],[c,u]=[0,null],h=CE*v0;for(let v=0;v<=h;v++){let M=e(n.state(n.epoch+v*s)),[w,E,_]=[r,o,t].map(I=>S0(I,M));a.push(Math.atan2(Math.hypot(w,E),_));let b=Math.atan2(E,w);u!==null&&(c+=Math.atan2(Math.sin(b-u),Math.cos(b-u))),u=b,l.push(c)}let[d,f]=[Math.min(...a),Math.max(...a)],p=IE(a),[x,m,g]=p.length>1?[p[0],p.at(-1),p.length-1]:[0,h,null],y=(M0(l,m)-M0(l,x))/((m-x)*s);return{least:d,most:f,swing:g?(m-x)*s/g:null,around:y}}var M0=(n,e)=>{let t=Math.min(Math.floor(e),n.length-2);return n[t]+(e-t)*(n[t+1]-n[t])};function IE(n){let e=[];for(let t=1;t+1<n.length;t++){let[i,s,r]=[n[t-1],n[t],n[t+1]];s>i&&s>=r&&i-2*s+r<0&&e.push(t+.5*(i-r)/(i-2*s+r))}return e}function PE([n,e,t]){let i=Math.abs(t)<.9?[0,0,1]:[1,0,0],s=[i[1]*t-i[2]*e,i[2]*n-i[0]*t,i[0]*e-i[1]*n],r=Math.hypot(...s),[o,a,l]=s.map(c=>c/r);return[[o,a,l],[e*l-t*a,t*o-n*l,n*a-e*o]]}function Fa([n,e,t,i],[s,r,o]){let[a,l,c]=[2*(t*o-i*r),2*(i*s-e*o),2*(e*r-t*s)];return[s+n*a+t*c-i*l,r+n*l+i*a-e*c,o+n*c+e*l-t*a]}var LE=2e3,NE=5*Math.PI/180,DE=["rate","spin.tilt","spin.rate"],UE={body:{moments:3},system:{kind:0,damping:1,sink_rate:1,linear_drag:1,quadratic_drag:1},spin:Us};function FE({moments:n,rate:e=0,linear_drag:t=0,quadratic_drag:i=0,momentum:s,attitude:r=[1,0,0,0],epoch:o=0}){let a=s.map((c,u)=>c/n[u]),l=Fs(a);return{moments:n,velocity:a,attitude:r,epoch:o,about:l,around:sn(a,l).around,momentum:s,rate:e,linear_drag:t,quadratic_drag:i}}function OE(n){let e=1/(Math.hypot(...ri(n))||1);return[{key:"rate",label:"losses inside, \u03B1",unit:"s/(kg m\xB2)",value:n.rate,low:0,high:5*Math.max(n.rate,.02*e),power:2},...Os(n.moments),...Bs(n)]}var BE=(n,e,t)=>e==="rate"?{...n,rate:t}:ks(n,e,t),kE=n=>new Pa({...n,momentum:ri(n)}),zE=({moments:n,rate:e,linear_drag:t,quadratic_drag:i,velocity:s,attitude:r})=>({body:{moments:n},system:{kind:"damped-body",sink_rate:e,linear_drag:t,quadratic_drag:i},spin:{angular_velocity:s,attitude:r}});function GE(n,e){let{system:t={}}=e,i={...n};for(let[o,a]of[["sink_rate","rate"],["linear_drag","linear_drag"],["quadratic_drag","quadratic_drag"]])t[o]!==void 0&&(i[a]=t[o]);let s=zs(i,e);if(t.damping===void 0)return s;let r=Math.hypot(...ri(s));return{...s,rate:r>0?t.damping/r:0}}function VE(n,e){let{moments:t,rate:i,linear_drag:s,quadratic_drag:r,velocity:o,attitude:a}=n,l=Math.hypot(...ri(n)),c=i>0&&l>0?`damping = ${He(i*l)}
`:"",u=s>0?`linear_drag = "${He(s)} N*m*s"
`:"",h=r>0?`quadratic_drag = "${He(r)} N*m*s^2"
`:"";return!c&&!u&&!h?null:`[body]
moments = ${Wn(t,"kg*m^2")}

[system]
kind = "damped-body"
${c}${u}${h}
[spin]
angular_velocity = ${Wn(o,"rad/s")}
attitude = [${a.map(He).join(", ")}]

[time]
until = "${He(e)} s"
`}function HE({moments:n,velocity:e,rate:t},i){let{energy:s,momentum:r}=i.state(i.epoch),o=Math.hypot(...r);if(!(o>0))return[["what it does","at rest"]];let[a,,l]=si(n).map(d=>n[d]),c=[["what it does",t>0&&a<l?"loses energy and ends spinning about its axis of largest moment":"keeps |L|"]],u=o*o/(2*l);c.push(["energy it can lose inside",`${et(100*(s-u)/s,3)} %`]);let h=t>0?w0(i,Math.hypot(...e)):null;return h!==null&&c.push(["within 5\xB0 of the flat spin after",En(h,h)]),c}var WE=({velocity:n,rate:e},t)=>e>0?w0(t,Math.hypot(...n)):null;function w0(n,e){let t=2*Math.PI/e/4,i=null;for(let s=0;s<4*LE;s++){let{angleToMajorAxis:r}=n.state(n.epoch+s*t);if(!(r<NE))i=null;else{if((i??=s*t)<.5*s*t)return i;if(i===0)return 0}}return i}var ff={};ps(ff,{asSpec:()=>JE,changed:()=>jE,controls:()=>ZE,facts:()=>tT,from:()=>$E,keys:()=>XE,make:()=>KE,toml:()=>eT,withSpec:()=>QE});var df=Math.PI/180,qE=.02,Oa={"air-layer":["viscosity","Pa*s","viscosity of the air"],"boundary-layer":["coefficient","W*s^2.5","loss in the boundary layer"],"viscous-contour-friction":["coefficient","W*s^2","viscous friction of the contact"],"dry-contour-friction":["coefficient","","dry friction of the contact"],"rolling-couple":["arm","m","lever arm of rolling friction"],"drilling-friction":["arm","m","lever arm of drilling friction"]},XE={system:{kind:0,mass:1,radius:1,thickness:1,gravity:1,tilt:1},dissipation:Object.fromEntries(Object.keys(Oa).map(n=>[n,1]))};function $E({mass:n,radius:e,half_thickness:t,diametral_moment:i,axial_moment:s,gravity:r,dissipation:o,start:a,epoch:l=0}){let u=Math.abs(s-.5*n*e**2)<1e-12*s&&Math.abs(i-n*(.25*e**2+t**2/3))<1e-12*i?null:[i/(n*e**2),s/(n*e**2)],h={mass:n,radius:e,half_thickness:t,shares:u,gravity:r,dissipation:o,tilt:a[0],heading:a[1],face:a[2],start:a,epoch:l};return{...h,moments:Pu(h),steady:YE(h)}}var Pu=({shares:n,mass:e,radius:t,half_thickness:i})=>{let[s,r]=n?n.map(o=>o*e*t**2):[e*(.25*t**2+i**2/3),.5*e*t**2];return[s,s,r]},A0=n=>{let[e,,t]=Pu(n),{mass:i,radius:s,half_thickness:r,gravity:o,dissipation:a}=n,l=Object.entries(a).map(([c,u])=>({law:c,[Oa[c][0]]:u}));return{mass:i,radius:s,half_thickness:r,gravity:o,diametral_moment:e,axial_moment:t,dissipation:l}},E0=n=>mo.rollingStart({...A0(n),tilt:n.tilt,heading:n.heading,face:n.face});function YE(n){try{let e=E0(n),t=Math.hypot(...e.slice(6));return[6,7].every(i=>Math.abs(e[i]-n.start[i])<qE*t)}catch{return!1}}function ZE(n){let{tilt:e,radius:t,half_thickness:i,mass:s,gravity:r,dissipation:o}=n;return[{key:"tilt",label:"tilt of the face at first",unit:"\xB0",si:df,value:e,low:Math.min(e,df),high:80*df,log:!0},{key:"radius",label:"radius",unit:"mm",si:.001,value:t,low:t/5,high:5*t,log:!0},{key:"thickness",label:"thickness",unit:"mm",si:.001,value:2*i,low:0,high:t},{key:"mass",label:"mass",unit:"g",si:.001,value:s,low:s/20,high:20*s,log:!0},{key:"gravity",label:"gravity",unit:"m/s\xB2",value:r,low:r/10,high:3*r,log:!0},...Object.entries(o).map(([a,l])=>({key:`law.${a}`,label:Oa[a][2],unit:Oa[a][1].replace("*"," ").replace("^2.5","^(5/2)").replace("^2","\xB2"),value:l,low:l/100,high:100*l,log:!0}))]}function jE(n,e,t){let[i,s]=e.split(".");return Iu(s?{...n,dissipation:{...n.dissipation,[s]:t}}:i==="thickness"?{...n,half_thickness:.5*t}:{...n,[i]:t})}function Iu(n){let e={...n,steady:!0,epoch:0};return{...e,start:E0(e),moments:Pu(e)}}var KE=n=>new mo({...A0(n),start:n.start,epoch:n.epoch}),JE=({mass:n,radius:e,half_thickness:t,gravity:i,tilt:s,dissipation:r})=>({system:{kind:"euler-disk",mass:n,radius:e,thickness:2*t,gravity:i,tilt:s},dissipation:r});function QE(n,{system:e={},dissipation:t={}}){let i={...n,dissipation:{...n.dissipation,...t}};for(let[s,r]of Object.entries(i.dissipation))r===0&&delete i.dissipation[s];for(let s of["mass","radius","gravity","tilt"])e[s]!==void 0&&(i[s]=e[s]);return e.thickness!==void 0&&(i.half_thickness=.5*e.thickness),Iu(i)}function eT(n,e){if(!n.steady)return null;let{mass:t,radius:i,half_thickness:s,shares:r,gravity:o,tilt:a,heading:l,dissipation:c}=n,[u,,h]=Pu(n),d=r?`axial_moment = "${He(h)} kg*m^2"
diametral_moment = "${He(u)} kg*m^2"
`:"",f=Object.entries(c).map(([p,x])=>{let[m,g]=Oa[p];return`{ law = "${p}", ${m} = ${g?`"${He(x)} ${g}"`:He(x)} }`});return`[system]
kind = "euler-disk"
mass = "${He(t)} kg"
radius = "${He(i)} m"
thickness = "${He(2*s)} m"
${d}gravity = "${He(o)} m/s^2"
tilt = "${He(a)} rad"
heading = "${He(l)} rad"
dissipation = [${f.join(", ")}]

[time]
until = "${He(e)} s"
`}function tT(n,e){let t=e.state(e.epoch),i=t.parts[6]/Math.sin(t.tilt),s=2*Math.PI/Math.abs(i),r=e.state(e.epoch+20*s),o=r.balances.energy?r.balances.energy.received-t.balances.energy.received:0,a=[["contact goes round every",`${et(s,4)} s`],["energy at first",`${et(t.energy,5)} J`],["energy less losses, change in 20 rounds",et(Math.abs(r.energy-o-t.energy)/t.energy,2)]];return o&&a.push(["lost in 20 rounds",`${et(-100*o/t.energy,3)} %`]),r.ended&&a.push(["ends",r.ended==="flat"?"flat on the table, within 20 rounds":W("by {event}, within 20 rounds",{event:W(r.ended)})]),a}var Lf={};ps(Lf,{asSpec:()=>MR,changed:()=>yR,controls:()=>gR,dragged:()=>dR,event:()=>AR,facts:()=>wR,first:()=>fR,from:()=>mR,keys:()=>pR,make:()=>vR,toml:()=>SR,withDirection:()=>_R,withSpec:()=>bR});var It=(n,e)=>n>e?n:e,oi=(n,e)=>n<e?n:e;function R0(n){let e=Math.round(n);return(e-n===.5&&e%2!==0?e-1:e)+0}var T0=new DataView(new ArrayBuffer(8));function pn(n){if(n===0)return 0;T0.setFloat64(0,n);let e=T0.getUint32(0)>>>20&2047;return e===0?pn(n*2**100)-100:e-1022}function qe(n,e){let t=Math.max(-1e3,Math.min(1e3,e)),i=n*2**t;return e===t?i:qe(i,e-t)}var C0=2e-8,nT=20,iT=3;function xo(n,e,t,i){let{0:s,1:r}=Sn(n),o=s*i+r*(t+i)+e*t;return[-(s*t),1-o*(1-.5*o)]}function Lu(n,e,t,i){let{0:s,1:r,2:o}=ts(n,i),{0:a,1:l}=kt((1-t)*o,s),{0:c,1:u}=kt(a,e[0]),h;({0:c,1:h}=Ii(c,r+(e[1]+(l+u))));let d=t*R0(c);return[c-d,h,t*o+d]}function Ba(n,e){let t=1+Math.sqrt(e),i=.5/((1+e)*t*t),s=i*n,r=s*s*(s*s);return i*(1+r*(2+r*(15+r*(150+r*1707))))}function Nu(n,e){let t=e*e*(e*e),i=2*(e+t+t*t*e);return Te(n,[-n[0]*(i*(2+i)/((1+i)*(1+i))),0])}function sT(n,e,t,i,s){let r=xe(n,e),o=Te(t,r);return i=de(xe(i,be(at(t,r),o)),.5),[de(Te(n,e),.5),Ns(r),de(be(wn(o),t),.25),i,Te(s,i)]}function I0(n,e,t){let i=de(Te(n,e),.5),s=.5*(n[0]-e[0]+(n[1]-e[1])),r=at(t,wn(i)),o=r[0]+r[1]+s*s;return[s/i[0],o/(2*i[0]*i[0]+o),i]}function rT(n,e,t,i,s){let r=.5*i*e,o=r+r*(.25*(e*e-.5*n*n));return[Te(t,[-.25*t[0]*n*n,0]),Te(s,[o,0])]}function oT(n,e,t){let i=oi(pn(n[0]),0*n[0]),s=qe(1,-i),r=[1,0];return[[de(n,s),de(e,s),de(de(t,s),s),r,r],i]}function aT(n){let{0:e,1:t,2:i,3:s,4:r}=n;return sT(e,t,i,s,r)}function lT(n){let{0:e,1:t}=I0(n[0],n[1],n[2]);return Math.abs(e)<C0&&Math.abs(t)<C0}function cT(n){let{0:e,1:t,2:i}=I0(n[0],n[1],n[2]);return rT(e,t,i,n[3][0],n[4])}function ka(n,e,t){let{0:i,1:s}=oT(n,e,t),r=i;for(let l=0;l<nT&&!(l>=iT&&lT(r));l++)r=aT(r);let{0:o,1:a}=cT(r);return[de(o,qe(1,s)),a]}function pf(n,e){let t=n.start[0],{0:i,1:s,2:r,3:o,4:a,5:l,6:c,7:u,8:h,9:d}=n.series,{0:f,1:p}=ts(n.first,e),{0:x,1:m}=ts(n.second,e),g=f+(p-t),y=x+(m+t),{0:v,1:M}=nn(g-Ct(g)),{0:w,1:E}=nn(y-Ct(y)),_=M*E+v*w,b=w*M-E*v,I=b+b,T=1-I*b,L=I*_,D=i+T*(s+T*r),B=L*(o+T*a),P=l+T*(c+T*u),O=L*(h+T*d);return[M*D-v*B,M*B+v*D,E*P-w*O,E*O+w*P]}function mf(n,e){let{1:t,2:i,3:s,4:r}=n.nome,{0:o,1:a}=ts(n.first,e),{0:l,1:c,2:u}=Lu(n.second,n.start,r,e);u=n.parity+u,u=u-4*Ct(.25*u);let h=o-.25*u;h=h-Ct(h)+(a-l*s);let d=l<0?-1:1,f=l*d,p=c*d,{0:x,1:m}=xo(f,p,t,i),g=It(.5-f,0),{0:y,1:v}=xo(g,(.5-g-f)*r-p,t,i);return[h,d,u,x,m,y,r*v]}function gf(n,e,t,i,s,r){let{0:o,1:a,2:l,3:c,4:u,5:h,6:d,7:f,8:p,9:x}=n.series,m=n.nome[0],{0:g,1:y}=nn(e-Ct(e)),v=m*m,M=v*v,w=m*r,E=w*w*v,_=E*w*M,b=_*w*M*v,I=v*s*s,T=M*I*s,L=M*v*T*s,D=M*M*L*s,B=u*(b+D),P=x*(b-D),O=-x*(b+D),H=u*(b-D);B=B+c*(_+L),P=P+p*(_-L),O=O+p*(_+L),H=H-c*(_-L),B=B+l*(E+T),P=P+f*(E-T),O=O-f*(E+T),H=H+l*(E-T),B=B+a*(w+I),P=P+d*(w-I),O=O+d*(w+I),H=H-a*(w-I),B=B+o*(1+s),P=P+h*(1-s),O=O-h*(1+s),H=H+o*(1-s),P=P*t,H=H*t;let V=1-2*(i-2*Math.floor(.5*i));return[y*B-g*P,y*P+g*B,V*(y*O-g*H),V*(y*H+g*O)]}function P0(n,e){let{0:t,1:i,2:s,3:r}=e,o=t*t+i*i,a=s*s+r*r,l=1/(o+a),c=Math.sqrt(l),u=l+l,h=(t*s+i*r)*u,d=(t*r-i*s)*u,f=(o-a)*l,p=t*c,x=i*c,m=s*c,g=r*c,y=n.toAttitude,v=n.toMomentum;return[y[0]*p+y[1]*x+y[2]*m+y[3]*g,y[4]*p+y[5]*x+y[6]*m+y[7]*g,y[8]*p+y[9]*x+y[10]*m+y[11]*g,y[12]*p+y[13]*x+y[14]*m+y[15]*g,v[0]*h+v[1]*d+v[2]*f,v[3]*h+v[4]*d+v[5]*f,v[6]*h+v[7]*d+v[8]*f]}function L0(n,e,t){let{0:i,1:s}=Sn(e);if(n.full!==0)return P0(n,pf(n,[i,s,t]));let{0:r,1:o,2:a,3:l,4:c,5:u,6:h}=mf(n,[i,s,t]),d=Math.exp(l)*c,f=Math.exp(u)*h;return P0(n,gf(n,r,o,a,d,f))}var uT=1e-14;function hT(n,e){let{0:t,1:i,2:s}=n.moments,{0:r,1:o,2:a}=n.momentum,l=n.longAxis?5:4;return l=t===i||i===s?3:l,l=e.separatrix?6:l,l=e.constant?2:l,l=t===s?1:l,r===0&&o===0&&a===0?0:l}function dT(n,e,t,i,s){let{0:r,1:o,2:a}=n.moments,l=n.B[0],c=n.C[0],u=n.P[0],h=n.Q[0],d=n.G2[0],f=Te(n.P,xe(mt(n.longAxis?-a:r,o),n.G2)),p=xe(be(f,e.G),i),x=at(s,at(t,p)),m=Math.PI*u/(Math.sqrt(l*c)*d),g=2*Math.PI*(u/(c*d))/(1+Math.sqrt(h/(c*d)));return n.A[0]===0?g:u/(l*d)<uT?m:x[0]}function za(n,e,t,i){return n.constant?e:n.separatrix?t:i}function N0(n,e){let t=de(Pi,2),i=be(t,e.mean),s=xe(e.precession,i),r=be(xe(i,n.V),[n.rateScale,0*n.rateScale]),o=de(be(e.precession,n.V),n.rateScale),a=n.longAxis?-1:1,l=Math.sqrt(n.A[0]/n.B[0])*(n.rootP/Math.sqrt(n.Q[0])),c=dT(n,e,s,i,t);return{regime:hT(n,e),encircledAxis:za(e,-1,-1,n.order[2]),modulus:za(e,NaN,1,l),period:za(e,NaN,1/0,r[0]),precessionRate:e.constant?NaN:a*o[0],precessionPerPeriod:za(e,NaN,1/0,a*s[0]),solidAngle:za(e,NaN,NaN,c)}}function fT(n){let e=Yt(xe(n.B,n.Q)),t=xe(Yt(n.C),n.rootS),i=n.B[0]>=n.A[0],s=xe(i?n.Q:n.B,n.C);s=i?s:xe(s,n.G2);let{0:r,2:o}=n.canonical,a=!(e[0]>0)||!(n.rootP>0)||r===0&&o===0,l=!(n.C[0]>0&&n.rootS[0]>0)&&!a,c=a||l,u=[1,0];return[{modulusRate:e,constant:a,separatrix:l},c?u:e,c?u:t,c?u:s]}function pT(n,e,t,i){let s=Yt(n.G2),r=n.B[0]>=n.A[0],{0:o,1:a,2:l}=n.moments,c=n.longAxis?-1:1,u=mt(c*(n.longAxis===r?o:l),a),h=xe(r?n.A:n.P,i),d=r?de(h,-.5):de(be(h,n.G2),.5),f=xe(s,Te(u,d)),p=r?f:Te(f,t),x=xe(s,mt(c*o,l));return p=e.separatrix?x:p,{modulusRate:e.modulusRate,mean:t,precession:p,G:s,constant:e.constant,separatrix:e.separatrix}}function D0(n){let{0:e,1:t,2:i,3:s}=fT(n),{0:r,1:o}=ka(t,i,s);return pT(n,e,r,o)}function U0(n,e,t){let i=de(be(so,e.V),e.rateScale),s=de(xe(t.precession,i),.5),r=de(xe(t.mean,i),2),o=de(r,.25),a=de(be(t.modulusRate,e.V),e.rateScale),l=n?at(s,o):s,c=t.separatrix?a:n?Te(s,o):r,{0:u,1:h}=Sn(l[0]),{0:d,1:f}=Sn(c[0]);return[[u,h,l[1]],[d,f,c[1]]]}var jt=(n,e)=>[...n,...e],xf=n=>n.map(e=>-e),Tn=(n,e)=>n.flatMap(t=>mt(t,e));function F0(n,e){let t=[...n];for(;e>0;e--)for(let i=1;i<t.length;i++){let{0:s,1:r}=kt(t[i-1],t[i]);t[i-1]=r,t[i]=s}return t}var Di=(n,e)=>n.length>e?F0(n,e+1).slice(-e):n;function Rn(n){let e=F0(n,5),t=e.pop();return kt(t,e.reduce((i,s)=>i+s))}var mT=11830521861667747e-287,gT=100,xT=1e-280,yT=.01;function yf(n,e,t){let i=e[0]<n[0];return[[i?e[0]:n[0],i?e[1]:n[1],i?e[2]:n[2]],[i?n[0]:e[0],i?n[1]:e[1],i?n[2]:e[2]],i?-t:t]}function _f(n,e){return n===0?e:Math.abs(n)}function _T(n,e){let{0:t,1:i,2:s}=yf([n[0],e[0],0],[n[1],e[1],1],1),r;({0:i,1:r,2:s}=yf(i,[n[2],e[2],2],s)),{0:t,1:i,2:s}=yf(t,i,s);let o=It(It(Math.abs(t[1]),Math.abs(i[1])),Math.abs(r[1])),a=oi(oi(_f(t[1],o),_f(i[1],o)),_f(r[1],o)),l=pn(o)-(a<mT*o?gT:0),c=pn(r[0]);return{moments:[qe(t[0],-c),qe(i[0],-c),qe(r[0],-c)],momentum:[s*qe(t[1],-l),s*qe(i[1],-l),s*qe(r[1],-l)],order:[t[2],i[2],r[2]],parity:s,momentumScale:qe(1,l),rateScale:qe(1,l-c)}}function vT(n){let{0:e,1:t,2:i}=n.moments,{0:s,1:r,2:o}=n.momentum,a=Vn(kt(t,-e),i),l=Vn(kt(i,-t),e),c=Vn(kt(i,-e),t),u=Ls(s),h=Ls(r),d=Ls(o),f=Te(xe(c,u),xe(l,h)),p=Te(xe(a,h),xe(c,d));return{A:a,B:l,C:c,P:f,Q:p,G2:Te(Te(u,h),d)}}function B0(n){return pn(It(Math.abs(n.momentum[0]),Math.abs(n.momentum[2])))}function MT(n){let e=B0(n),{0:t,2:i}=n.momentum;return[n.moments,qe(t,-e),qe(i,-e)]}function bT(n,e,t,i){let s=xe(n,Ls(t)),r=at(s,xe(e,Ls(i)));return[r,Math.abs(r[0])<yT*s[0]]}function O0(n,e,t){return Tn(Tn(Tn(n,e),t),t)}function ST(n,e,t){let{0:i,1:s,2:r}=n;return Rn(jt(O0(kt(s,-i),r,e),O0(kt(r,-s),-i,t)))}function wT(n){let{0:e,1:t,2:i}=n[0];return ST(e,t,i)}function AT(n){return n[1]}function ET(n,e){let t=MT(n),{0:i,1:s}=bT(e.A,e.B,t[1],t[2]);return s?wT([t,i]):AT([t,i])}function TT(n,e,t,i,s){let r=pn(It(Math.abs(t),Math.abs(s)));return t=qe(t,-r),s=qe(s,-r),n>xT?Math.sqrt(n):qe(Math.sqrt(e*t*t+i*s*s),r)}function RT(n,e,t){let i=t[0]>0,s=i?e.B:e.A,r=i?e.A:e.B,o=i?e.Q:e.P,a=i?e.P:e.Q,{0:l,1:c,2:u}=n.momentum;({0:l,1:u}=[i?u:l,i?l:u]);let h=u<0?-1:1,{0:d,1:f,2:p}=n.moments,x=i?1:-1,m=qe(1,B0(n)),g=de(t,x),{0:y,1:v,2:M}=n.order;return{moments:n.moments,momentum:n.momentum,canonical:[l*h,c,u*h],A:s,B:r,C:e.C,P:o,Q:a,S:de(de(g,-m),m),rootS:de(Yt(g),m),rootP:TT(o[0],e.C[0],l,r[0],c),V:Vn(mt(d,f),p),G2:e.G2,longAxis:i,order:[i?M:y,v,i?y:M],parity:n.parity,halfTurn:h,momentumScale:n.momentumScale,rateScale:n.rateScale}}function k0(n,e){let t=_T(n,e),i=vT(t);return RT(t,i,ET(t,i))}var CT=38725919148493183e-137,IT=6223015277861142e-76,PT=[138.62943611198907,-33555121496085278e-31],LT=[0,0,0,0,0,0,0,0,0],NT=[0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0];function Ga(n,e,t,i,s,r,o){let a=(n-e)/(n+e),l=1+a,c=Math.sqrt(1-a*(1-t)/(1+t));s=2*s/(l*(r+o));let u=Math.sqrt(1+a*(o-r)/(o+r));return[.5*(n+e),Math.sqrt(n*e),c,i*(c/l),s,u]}function z0(n,e,t,i,s){let r,o,a,l;return{0:a,1:l,2:e,3:r,4:o,5:s}=Ga(1,n,e,1,t,i,s),{0:a,1:l,2:e,3:r,4:o,5:s}=Ga(a,l,e,r,o,1,s),{0:a,1:l,2:e,3:r,4:o,5:s}=Ga(a,l,e,r,o,1,s),{0:a,1:l,2:e,3:r,4:o,5:s}=Ga(a,l,e,r,o,1,s),{0:a,1:l,2:e,3:r,4:o,5:s}=Ga(a,l,e,r,o,1,s),[r,o]}function DT(n){let e=n.A[0],t=n.B[0],i=n.C[0],s=n.Q[0],{0:r,1:o,2:a}=n.canonical,l=t*s,c=e*n.P[0]/l,u=-i*n.S[0]/l,h=Ba(c,Math.sqrt(u)),d=h*c,f=n.rootP/Math.sqrt(s),p=Math.sqrt(t),x=Math.sqrt(i),{0:m,1:g}=z0(Math.sqrt(u),a*Math.sqrt(i/s),p,p,x),y=g+Math.sqrt(f*f+g*g),v=f/y,M=e/t*h*y*y,w=v*v,E=d*d,_=M*M,b=E*d,I=E*E,T=I*I,L=w*w,D=-d*w,B=-E*M,P=I*E*L,O=T*_,H=-b*w,V=T*E*L,ee=I*_;return{rise:p*o*m,run:x*r,series:[1-(P+O),D+B,2*(P+O),D-B,2*(P-O),v*(1-(V+ee)),v*(H-M),2*v*(V+ee),v*(H+M),2*v*(V-ee)]}}function UT(n,e){return Math.atan2(n,e)*(.25/Math.PI)}function FT(n,e){return{start:[n,0],series:e,nome:[0,0,0,0,0],parity:0}}function OT(n){let e=DT(n.body);return FT(UT(e.rise,e.run),e.series)}function BT(n,e){let t=n.B[0],i=n.C[0],s=n.P[0],r=n.Q[0],{0:o,1:a,2:l}=n.canonical,c=t*r,u=e.separatrix?1:Math.sqrt(n.A[0]*s/c),h=e.separatrix?0:-i*n.S[0]/c,d=Math.sqrt(i),f=Math.sqrt(s/t)/e.G[0],p=Math.abs(Math.sqrt(t)*a),x=d*Math.abs(o),m=d*l*Math.sqrt(s/r),g=x+m<CT*p,{0:y,1:v}=z0(u,f,g?IT*p:p,x,m);return{nome:h*Ba(h,u),tangent:Math.sqrt(r/s)*y,sinh:v,huge:g}}function kT(n){let e=Math.log(2*n);return[e,.5*Math.exp(e)]}function zT(n){let e=Math.asinh(n);return[e,Math.sinh(e)]}function GT(n){let{0:e,1:t}=n.huge?kT(n.sinh):zT(n.sinh);return{x:e,sinh:t,y:Math.atan(n.tangent)}}function VT(n,e,t,i){let{0:s,1:r}=n.canonical,o=t.huge?i.sinh:Math.sqrt(1+i.sinh*i.sinh),a=Ii(i.x,(t.sinh-i.sinh)/o);a=t.huge?Te(a,PT):a,a=de(a,r<0==s<0?1:-1);let l=WT(e.modulusRate,e.mean,t.nome);l=e.separatrix?[1,0]:l;let{0:c,1:u}=Sn(l[0]),h=e.separatrix?0:1;return{start:be(a,l),series:qT(i.y),nome:[Math.sqrt(t.nome),c,u+l[1],h*i.y*(.5/Math.PI),h],parity:s<0?1:0}}function HT(n){let e=BT(n.body,n.rates);return VT(n.body,n.rates,e,GT(e))}function WT(n,e,t){return Nu(be(xe(n,Pi),e),t)}function qT(n){let e=(.5*n-.25*Math.PI)*(.5/Math.PI),{0:t,1:i}=nn(e),{0:s,1:r}=nn(3*e),{0:o,1:a}=nn(5*e-Ct(5*e)),{0:l,1:c}=nn(7*e-Ct(7*e)),{0:u,1:h}=nn(9*e-Ct(9*e));return[i,r,a,c,h,t,s,o,l,u]}function Mf(n,e,t,i,s){let{0:r,1:o,2:a,3:l}=n;return[r*e-o*t-a*i-l*s,r*t+o*e+a*s-l*i,r*i-o*s+a*e+l*t,r*s+o*i-a*t+l*e]}function vf(n,e,t,i,s){return e[0]===n?t:e[1]===n?i:s}function Du(n,e,t,i,s,r){return Mf(n,t,vf(0,e,i,s,r),vf(1,e,i,s,r),vf(2,e,i,s,r))}function bf(n){let{0:e,1:t,2:i}=n.order,s=n.parity,r=n.parity*n.halfTurn;return[[e===0?r:0,t===0?s:0,i===0?r:0],[e===1?r:0,t===1?s:0,i===1?r:0],[e===2?r:0,t===2?s:0,i===2?r:0]]}function XT(n,e,t,i){let{0:s,1:r,2:o,3:a}=i,l=Math.sqrt(s*s+r*r+(o*o+a*a));s=s/l,r=r/l,o=o/l,a=a/l;let c=n.longAxis?-n.parity:n.parity,u=n.order,h=c*n.halfTurn,d=Du(t,u,s,-h*a,c*o,-h*r),f=Du(t,u,r,h*o,c*a,h*s),p=Du(t,u,o,-h*r,-c*s,h*a),x=Du(t,u,a,h*s,-c*r,-h*o),m=e*n.momentumScale,{0:g,1:y,2:v}=bf(n);return[[d[0],f[0],p[0],x[0],d[1],f[1],p[1],x[1],d[2],f[2],p[2],x[2],d[3],f[3],p[3],x[3]],[m*g[0],m*g[1],m*g[2],m*y[0],m*y[1],m*y[2],m*v[0],m*v[1],m*v[2]]]}function $T(n){return n.A[0]*n.P[0]<=-n.C[0]*n.S[0]}function YT(n){let e=0*n.start[0];return pf(n,[e,e,e])}function ZT(n){let e=0*n.start[0],{0:t,1:i,2:s,3:r,4:o,5:a,6:l}=mf(n,[e,e,e]);return gf(n,t,i,s,Math.exp(r)*o,Math.exp(a)*l)}function jT(n){let e=n.body,t=n.rates,i=$T(e)&&!t.separatrix,{0:s,1:r}=U0(i,e,t),o=i?OT(n):HT(n),a=i?1:0,l={full:a,first:s,second:r,start:o.start,series:o.series,nome:o.nome,parity:o.parity,toAttitude:NT,toMomentum:LT},c=i?YT(l):ZT(l),{0:u,1:h}=XT(e,t.G[0],n.attitude,c);return{full:a,first:s,second:r,start:o.start,series:o.series,nome:o.nome,parity:o.parity,toAttitude:u,toMomentum:h}}function KT(n){let{0:e,1:t,2:i}=n.moments,{0:s,1:r,2:o}=n.momentum,a=0*n.rootP,l=be([s,a],[e,a]),c=be([r,a],[t,a]),u=be([o,a],[i,a]),h=Yt(Te(Te(wn(l),wn(c)),wn(u))),d=de(de(xe(h,so),.5),n.rateScale),{0:f,1:p}=Sn(d[0]);return[f,p,d[1]]}function JT(n,e){let{0:t,1:i,2:s}=n,{0:r,1:o,2:a}=e,l=It(It(Math.abs(r),Math.abs(o)),Math.abs(a));l=l>0?l:1;let c=oi(oi(t,i),s);r=r/l*(c/t),o=o/l*(c/i),a=a/l*(c/s);let u=Math.sqrt(r*r+o*o+a*a);return u=u>0?u:1,[r/u,o/u,a/u]}function QT(n){let e=0*n.body.rootP,t=e+1,{0:i,1:s,2:r}=JT(n.moments,n.momentum),o=Mf(n.attitude,1,e,e,e),a=Mf(n.attitude,0,i,s,r),{0:l,1:c,2:u}=n.momentum;return{full:t,first:KT(n.body),second:[e,e,e],start:[e,e],series:[t,e,e,e,e,e,e,e,e,e],nome:[e,e,e,e,e],parity:e,toAttitude:[o[0],a[0],e,e,o[1],a[1],e,e,o[2],a[2],e,e,o[3],a[3],e,e],toMomentum:[e,e,l,e,e,c,e,e,u]}}function G0(n){return n.rates.constant?QT(n):jT(n)}var e2=["rest","spherical","permanent","symmetric","short-axis","long-axis","separatrix"],yi=class{constructor({moments:e,momentum:t,attitude:i=[1,0,0,0],epoch:s=0}){this.moments=ro(e),this.momentumAtEpoch=An("momentum",t,3,"kg m\xB2/s"),this.attitudeAtEpoch=ao(oo(i)),this.epoch=wt("epoch",s,"seconds");let r={moments:this.moments,momentum:this.momentumAtEpoch,attitude:this.attitudeAtEpoch},o=k0(r.moments,r.momentum),a=D0(o);this._fastest=Math.max(...r.momentum.map((d,f)=>Math.abs(d/r.moments[f]))),this._motion=G0({...r,body:o,rates:a});let{first:l,second:c,toAttitude:u,toMomentum:h}=this._motion;_u([this._fastest,...l,...c,...u,...h]),this._curve={body:o,rates:a},this.energy=.5*r.momentum.reduce((d,f,p)=>d+f/r.moments[p]*f,0),this.momentumNorm=Math.hypot(...r.momentum),Object.assign(this,t2(o,a))}state(e){let[t,i]=yu(e,this.epoch,this._fastest);return vu(L0(this._motion,t,i))}angularVelocity(e){let t=this.state(e).momentum;return[t[0]/this.moments[0],t[1]/this.moments[1],t[2]/this.moments[2]]}along(e){let{body:t,rates:i}=this._curve,s=this.momentumAtEpoch;if(i.constant)return Array.from({length:e},()=>[...s]);let[r,o,a,l,c]=[t.A,t.B,t.C,t.P,t.Q].map(v=>v[0]),u=o*c,[h,d]=i.separatrix?[1,0]:[r*l/u,-a*t.S[0]/u],[f,p]=t.canonical,x=bf(t),m=t.rootP,g=Math.atan2(Math.sqrt(o)*p,Math.sqrt(a)*f),y=i.separatrix&&f<0?-1:1;return Array.from({length:e},(v,M)=>{let w=i.separatrix?Math.PI*(M/Math.max(e-1,1)-.5):g+2*Math.PI*M/e,E=y*Math.cos(w),_=y*Math.sin(w),b=[m/Math.sqrt(a)*E,m/Math.sqrt(o)*_,Math.sqrt(c/a)*Math.sqrt(d+h*E*E)];return x.map(I=>t.momentumScale*(I[0]*b[0]+I[1]*b[1]+I[2]*b[2]))})}};function t2(n,e){let t=N0(n,e),i=e2[t.regime];return{regime:i,encircledAxis:t.encircledAxis<0?null:t.encircledAxis,modulus:Hn(t.modulus),period:Hn(t.period),precessionRate:Hn(t.precessionRate),precessionPerPeriod:Hn(t.precessionPerPeriod),flipInterval:i==="symmetric"?null:Hn(.5*t.period),solidAngle:Hn(t.solidAngle)}}function Gs(n,e){let{0:t,1:i,2:s,3:r}=n,{0:o,1:a,2:l,3:c}=e;return r*c+s*l+i*a+t*o}function yo(n,e){let{0:t,1:i,2:s,3:r}=n,{0:o,1:a,2:l,3:c}=e;return r*(7*c)+s*(5*l)+i*(3*a)+t*o}function V0(n,e){let{0:t,1:i,2:s,3:r}=n,{0:o,1:a,2:l,3:c}=e;return r*(8*c)+s*(6*l)+i*(4*a)+t*(2*o)}function Uu(n,e){let{0:t,1:i}=ts(n,e);return t+i}function Sf(n,e){let{0:t,1:i}=n.signs,{0:s,1:r}=ts(n.third,e),o=s+(r+n.start[0]),{0:a,1:l}=nn(o-Ct(o)),c=1-2*a*a,u=2*a*l,h=l*c-a*u,d=a*c+l*u,f=h*c-d*u,p=d*c+h*u,x=f*c-p*u,m=p*c+f*u,g=[l,h,f,x],y=[a,d,p,m];return[Gs(n.aSum,y),-t*Gs(n.aGap,g),Gs(n.bSum,g),i*Gs(n.bGap,y),yo(n.aSum,g),t*yo(n.aGap,y),-yo(n.bSum,y),i*yo(n.bGap,g),Uu(n.first,e),Uu(n.second,e)]}function wf(n,e){let{1:t,2:i,3:s,4:r,5:o}=n.nome,{0:a,1:l}=n.signs,{0:c,1:u,2:h}=Lu(n.third,n.start,o,e),d=c<0?-1:1,f=c*d,p=u*d,{0:x,1:m}=xo(f,p,t,i),g=It(.5-f,0),{0:y,1:v}=xo(g,(.5-g-f)*o-p,t,i),M=.5*(h-2*Math.floor(.5*h)),w=c+u,E=Uu(n.first,e)+a*w*s,_=Uu(n.second,e)+l*w*r;return E=E-Ct(E)+M,_=_-Ct(_)+M,[d,E,_,x,m,y,o*v]}function Af(n,e,t,i,s,r){let o=n.nome[0],{0:a,1:l}=n.signs,c=s*s,u=r*r,h=c*c,d=c*h,f=d*h,p=f*h,x=o*o,m=x*o,g=o*u,y=x*u,v=m*u,M=o*c,w=x*c,E=m*c,_=x*x*c,b=y*y,I=v*v,T=g*g,L=b*y,D=I*I,B=w*w,P=E*E*E,O=_*_*(_*_);I=I*v;let H=[1+c,g*(1+d),b*(1+f),I*(1+p)],V=[1-c,g*(1-d),b*(1-f),I*(1-p)],ee=[u+M,T+B,L+P,D+O],X=[u-M,T-B,L-P,D-O],j=2*s;return[Gs(n.aSum,H),a*e*Gs(n.aGap,V),j*(n.constant+Gs(n.bSum,ee)),-l*e*j*Gs(n.bGap,X),e*yo(n.aSum,V),a*yo(n.aGap,H),e*j*V0(n.bSum,X),-l*j*V0(n.bGap,ee),t,i]}function H0(n,e){let{0:t,1:i,2:s,3:r,4:o,5:a,6:l,7:c,8:u,9:h}=e,{0:d,1:f}=n.rates,{0:p,1:x,2:m,3:g}=n.phases,y=1/(t*t+i*i+(s*s+r*r)),v=Math.sqrt(y),{0:M,1:w}=nn(u-Ct(u)),E=w*p-M*x,_=M*p+w*x;({0:M,1:w}=nn(h-Ct(h)));let b=w*m-M*g,I=M*m+w*g,T=(t*E-i*_)*v,L=(t*_+i*E)*v,D=(s*b-r*I)*v,B=(s*I+r*b)*v,P=t*l+i*c-(s*o+r*a),O=t*c-i*l-(r*o-s*a),H=i*s-t*r,V=t*s+i*r,ee=(d*P+f*H)*y,X=(d*O+f*V)*y,j=b*E+I*_,te=I*E-b*_,ve=n.reversed,Pe=ve<0,{0:Y,1:me}=Pe?[D,B]:[T,L],Me;return{0:y,1:Me}=Pe?[T,L]:[D,B],[Y,ve*y,ve*Me,me,ee*j-X*te,ve*(ee*te+X*j),n.axial]}function W0(n,e,t){let{0:i,1:s}=Sn(e);if(n.full!==0)return H0(n,Sf(n,[i,s,t]));let{0:r,1:o,2:a,3:l,4:c,5:u,6:h}=wf(n,[i,s,t]),d=Math.exp(l)*c,f=Math.exp(u)*h;return H0(n,Af(n,r,o,a,d,f))}var n2=-200,i2=-150,mn=[1,0],ns=[0,0];function Ou(n){return n.s0[0]<n.t0[0]}function Va(n){return n.lift>0&&Ou(n)&&n.D[0]>0}function Fu(n,e){return It(Math.abs(n),Math.abs(e))}function s2(n,e,t,i){let s=e<0,r=s?-1:1,o=Math.abs(e),{0:a,1:l,2:c,3:u}=i,{0:h,2:d}=n,{0:f,1:p,2:x}=t,m=It(Fu(f,p),Math.abs(x)),g=pn(h),y=pn(m),v=Math.floor(.5*(g+pn(o)+1)),M=m>0?It(y,v):v,w=o>0?M:y;return h=qe(h,-g),o=qe(qe(o,g-w),-w),{moments:[h,qe(d,-g)],momentum:[qe(f,-w),qe(r*p,-w),qe(r*x,-w)],quaternion:[s?-l:a,s?a:l,s?u:c,s?-c:u],reversed:s,lift:0*o,exponent:w,momentumScale:qe(1,w),rateScale:qe(1,w-g),G:de(mt(o,h),2)}}function r2(n,e){let{0:t,1:i,2:s,3:r}=n.quaternion,{0:o,1:a,2:l}=n.momentum,c=Fu(t,r),u=Fu(i,s),h=c<u,d=It(oi(c,u),Fu(o,a)),f=pn(d),p=de(n.G,2),x=mt(l,l),m=p[0]===x[0]&&p[1]===x[1]&&!h,g=d>0&&f<n2&&n.G[0]>0,y=g&&!m?i2-f:0,v=g&&m?0:1,M=h?0:y,w=h?y:0,E=n.reversed?-1:1,_=y-n.exponent;return{moments:n.moments,momentum:[v*qe(e[0],_),v*qe(E*e[1],_),l],quaternion:[qe(t,w),v*qe(i,M),v*qe(s,M),qe(r,w)],reversed:n.reversed,lift:y,exponent:n.exponent,momentumScale:n.momentumScale,rateScale:n.rateScale,G:n.G}}function o2(n,e,t,i,s,r,o,a,l,c,u,h,d){return{moments:n.moments,momentum:n.momentum,quaternion:n.quaternion,reversed:n.reversed,lift:n.lift,momentumScale:n.momentumScale,rateScale:n.rateScale,size:e,G:n.G,s0:de(be(t,e),2),t0:de(be(i,e),2),u0:be(s,e),p:de(be(r,e),-2),c:be(o,e),cPlus:be(a,e),twist:be(l,e),F:be(c,e),D:be(u,e),w2:h,lean:be(d,e)}}function dr(n,e,t,i){return jt(mt(n,e),mt(t,i))}function hr(n,e){return jt(Tn(n,e[0]),Tn(n,e[1]))}function a2(n){let{0:e,1:t,2:i,3:s}=n.quaternion;return Di(jt(dr(t,t,i,i),dr(e,e,s,s)),4)}function l2(n,e){let{0:t,1:i,2:s}=n.momentum,{0:r,1:o,2:a,3:l}=n.quaternion,c=dr(o,o,a,a),u=dr(r,r,l,l),h=dr(o,r,a,l),d=dr(o,l,-a,r),f=Di(jt(Tn(h,t),Tn(d,-i)),4),p=Di(jt(Tn(h,2*i),Tn(d,2*t)),4),x=Di(jt(p,Tn(c,-2*s)),4),m=Di(jt(p,Tn(u,2*s)),4),g=jt(hr(e,mt(t,t)),hr(e,mt(i,i))),y=de(n.G,-2);y=jt(hr(y,mt(o,o)),hr(y,mt(a,a)));let v=Di(jt(g,y),5),M=Di(jt(v,Tn(x,-s)),5),w=jt(hr(e,de(n.G,2)),hr(e,mt(s,-s))),E=Di(jt(w,xf(v)),5),_=Di(jt(Tn(v,s),hr(x,de(n.G,-1))),6);return o2(n,Rn(e),Rn(c),Rn(u),Rn(jt(u,xf(c))),Rn(f),Rn(x),Rn(m),Rn(p),Rn(M),Rn(E),Rn(dr(t,t,i,i)),Rn(_))}function q0(n,e,t,i){let s=s2(n,e,t,i);return l2(r2(s,t),a2(s))}var X0=40,c2=.01,u2=.002;function $0(n,e){let t=-n-e,i=n*e-t*t,s=n*e*t,r=i*i*(1/24-i*(5/208))-i*s*(3/44);return r=r+s*(3/104*s+.0625*i*i),r+s*(1/14)-.1*i}function Y0(n,e,t){let i=(n+e+t)/3;return It(It(Math.abs(i-n),Math.abs(i-e)),Math.abs(i-t))/i}function h2(n){let{0:e,1:t,2:i}=n,s=Math.sqrt(e),r=Math.sqrt(t),o=Math.sqrt(i),a=s*r+r*o+o*s;return[.25*(e+a),.25*(t+a),.25*(i+a)]}function Z0(n){return Y0(n[0],n[1],n[2])<=c2}function d2(n){let{0:e,1:t,2:i}=n,s=(e+t+i)/3;return Z0(n)?(1+$0(1-e/s,1-t/s))/Math.sqrt(s):NaN}function f2(n){let{0:e,1:t,2:i}=n,s=Yt(e),r=Yt(t),o=Ns(i),a=Te(xe(s,Te(r,o)),xe(r,o));return[de(Te(e,a),.25),de(Te(t,a),.25),de(Te(i,a),.25)]}function j0(n){return Y0(n[0][0],n[1][0],n[2][0])<=u2}function p2(n){let{0:e,1:t,2:i}=n,s=mn,r=be(Te(Te(e,t),i),[3,0]),o=$0(1-be(e,r)[0],1-be(t,r)[0]);return j0(n)?be(Te(s,[o,0*o]),Ns(r)):[NaN,NaN]}function m2(n,e){let t=e.d[0],i=e.t2[0];return[t/i,t*e.ZPlus[0]/(e.A[0]*i),e.t1[0]/i]}function g2(n,e){let t=e.d[0],i=e.s1[0],s=e.B[0];return[t*e.ZMinus[0]/(i*s),t/i,e.s2[0]*e.A[0]/(i*s)]}function x2(n,e){let t=n.G[0],i=e.ZPlus[0];return[t*e.t1[0]/i,t*e.t2[0]/i,e.A[0]/i]}function y2(n,e){let t=n.G[0],i=e.B[0];return[t*e.s2[0]/i,t*e.s1[0]/e.A[0],e.ZMinus[0]/i]}function _2(n){return[be(n.fromUpper,n.d),be(n.Y,n.A),be(n.fromLower,n.d)]}function Bu(n,e){let{0:t,1:i,2:s}=e,r=t+i,o=(n?0:r)>0;o=o&&r<1/0;let l=[o?t:1,o?i:1,1+0*t];for(let c=0;c<X0&&!Z0(l);c++)l=h2(l);return Math.sqrt(s)*d2(l)}function v2(n,e){let{0:t,1:i,2:s}=e,r=t[0]+i[0],o=mn,a=(n?0:r)>0;a=a&&r<1/0;let c=[a?t:o,a?i:o,o];for(let u=0;u<X0&&!j0(c);u++)c=f2(c);return xe(Yt(s),p2(c))}function K0(n,e,t){let i=t.permanent||t.steady,s=t.separatrix,r=e.d[0],o=Bu(i,m2(n,e)),a=Bu(i,g2(n,e));o=s?Math.atan2(Math.sqrt(e.t1[0]),Math.sqrt(r)):o,a=s||e.s2[0]===0?0:a;let l=t.steady?1/0:0,c=v2(i,_2(e));return{vAlpha:i?l:o,vBeta:i?l:a,wAlpha:Bu(i,x2(n,e)),wBeta:Bu(i,y2(n,e)),x0:i&&r<=0?ns:c}}function J0(n,e){let t=[1,0];return n[0]<e[0]?at(t,n)[0]:at(e,t)[0]}function M2(n,e){let t=n.momentum[2],i=n.c[0],s=n.cPlus[0],r=n.lean[0],o=t<0?-r:r,a=i*t<0&&s*t>0,l=a&&o>0?8:6;return l=a&&o===0?7:l,l=t===0&&i===0?5:l,l=e.steady?3:l,l=e.separatrix?9:l,l=e.permanent?n.s0[0]===0?1:2:l,l=n.G[0]===0?4:l,t===0&&e.permanent?0:l}function Ef(n,e,t,i){return n.permanent?e:n.separatrix?t:i}function Q0(n,e,t){let i=J0(e.s1,e.t1),s=J0(e.s2,e.t2);i=t.permanent?n.u0[0]:i,s=t.permanent?n.u0[0]:s;let r=Pi,o=Te(be(t.alpha,t.nutation),[t.signAlpha,0*t.signAlpha]),a=Te(be(t.beta,t.nutation),[t.signBeta,0*t.signBeta]),l=be(t.spin,t.nutation),c=xe(r,Te(o,a))[0],u=xe(r,Te(at(o,a),l))[0],h=be(Vn(r,n.moments[0]),de(t.nutation,n.rateScale))[0];return u=(n.reversed?-1:1)*u+0,{regime:M2(n,t),lowest:n.reversed?-s:i,highest:n.reversed?-i:s,period:Ef(t,NaN,1/0,h),precessionPerPeriod:Ef(t,NaN,NaN,c),spinPerPeriod:Ef(t,NaN,NaN,u)}}function b2(n,e,t,i,s){return n?t:be(xe(e,s),n?mn:i)}function S2(n,e,t,i,s,r,o){let a=be(xe(r,i),n?mn:o);return n?e[0]===0?t:s:a}function ex(n,e,t,i,s,r,o,a,l){let c=e[0]===0,u=be(n?xe(e,t):e,c?mn:n?i:s),h=at(mn,de(xe(be(o,r),l),.5));return n?de(xe(u,l),.25):at(xe(de(u,.5),h),a)}function w2(n,e,t){return be(Vn(kt(n,-e),t),[e,0])}function tx(n,e,t){let i=be(so,[e,0]);return xe(n,de(i,t))}function nx(n,e,t){return be(de(n,t),Vn(Pi,e))}function ix(n,e,t){let i=be(de(xe(n,Pi),.5),e);return[i,Nu(de(i,2),t)]}function sx(n){return n.ZPlus[0]<=2*n.A[0]}function rx(n,e){return xe(n.G,e.s2)[0]<=e.ZMinus[0]}function A2(n,e){let t=n.momentum[2],i=n.s0[0]===0||n.t0[0]===0,s=n.w2[0]===0&&(i||n.G[0]===0&&t===0),r=!(e.B[0]>0)&&!s,o=s||r,a=mn,l=b2(sx(e),e.A,e.ZPlus,e.t1,e.t2),c=rx(n,e),u=S2(c,n.c,e.A,e.B,e.ZMinus,e.s1,e.s2);return{rootA:o?a:Yt(e.A),rootB:o?a:Yt(e.B),alpha:o?a:l,beta:o?a:u,permanent:s,separatrix:r}}function E2(n,e,t,i,s,r){let o=de(i,.5),a=t.separatrix,l=n.cPlus[0]>=0?1:-1,c=n.c[0]>=0?1:-1,u=de(n.cPlus,l),h=de(n.c,c),d=rx(n,e),f=ex(sx(e),u,n.G,e.ZPlus,e.t1,e.t2,e.d,o,s),p=ex(d,h,n.G,e.ZMinus,e.s2,e.s1,e.d,o,r);f=de(a?de(u,.25):f,l),p=de(a?ns:p,d?-c:c);let x=!(e.d[0]>0||t.permanent||a);return{halfRoot:de(Yt(e.A),.5),nutation:a?ns:o,alpha:f,beta:p,signAlpha:l,signBeta:c,spin:w2(n.moments[0],n.moments[1],n.momentum[2]),permanent:t.permanent,separatrix:a,steady:x}}function Tf(n){return Vn(Kg,Va(n)?n.lift:0)}function T2(n,e){let t=e.halfRoot,i=de(n.cPlus,.25),s=mn,r=Pi,o=Va(n),a=de(be(xe(Tf(n),e.nutation),xe(r,t)),2),l=be(s,Te(s,a)),c=Te(i,xe(at(e.alpha,i),l));return{halfRoot:t,nutation:o?xe(e.nutation,l):e.nutation,alpha:o?c:e.alpha,beta:o?xe(e.beta,l):e.beta,signAlpha:e.signAlpha,signBeta:e.signBeta,spin:e.spin,permanent:e.permanent,separatrix:e.separatrix,steady:e.steady}}function ox(n,e){let t=A2(n,e),{0:i,1:s}=ka(t.rootA,t.rootB,t.alpha),{1:r}=ka(t.rootA,t.rootB,t.beta);return T2(n,E2(n,e,t,i,s,r))}function ax(n,e){let t=de(e.spin,.5),{0:i,1:s}=n.moments,r=be(mt(.5*n.momentum[2],i),[s,0]),o=e.permanent?r:Te(e.alpha,t),a=e.permanent?[-r[0],-r[1]]:at(e.beta,t);return[tx(o,i,n.rateScale),tx(a,i,n.rateScale)]}var R2=-400,C2=.8660254,I2=.1642,P2=-.0302,L2=2,N2=5,D2=8673617379884035e-34;function U2(n,e,t,i,s,r,o,a,l,c,u,h){let d=at(de(Vn(a,n),2),xe(e,xe(i,s)));d=at(d,de(xe(r,o),2));let f=at(at(de(xe(e,r),2),o),Ls(n));return u=xe(u,t),h=xe(h,t),[d,[f,xe(e,d),xe(wn(e),l)],[[-u[0],-u[1]],de(h,-2),xe(c,t)]]}function lx(n){let e=n[0][0],t=n[1][0],i=n[2][0],s=e/3,r=t-e*s,o=2*(s*s)*s-s*t+i,a=Math.sqrt(It(-r/3,0*r));return[s,a,a>0?-.5*o/(a>0?a*a*a:1):1]}function F2(n){let e=!(n.G[0]>0),t=mn,{0:i,1:s,2:r}=U2(n.momentum[2],n.G,be(t,e?t:n.G),n.s0,n.t0,n.u0,n.w2,n.twist,wn(n.p),wn(n.c),n.D,n.F),{0:o,1:a,2:l}=lx(s),{0:c,1:u,2:h}=lx(r),d=l>=0||e,f=d?l:h;f=oi(It(f,0*f),1+0*f);let p=C2+f*(I2+f*P2);p=(8*p*p*p+f)/(12*p*p-3),p=(8*p*p*p+f)/(12*p*p-3);let x=[d?s[0]:r[0],d?s[1]:r[1],d?s[2]:r[2]];return{upper:d,cubic:x,start:2*(d?a:u)*p-(d?o:c),f1:i}}function O2(n){return[[n.start,0*n.start],n.start,n.cubic]}function B2(n){let{0:e,2:t}=n,{0:i,1:s,2:r}=t,a=-Te(xe(Te(xe(Te(e,i),e),s),e),r)[0]/((3*e[0]+2*i[0])*e[0]+s[0]);return a=a-a===0?a:0,[Te(e,[a,0*a]),a,t]}function k2(n){let{0:e,1:t}=n;return e[0]>0&&Math.abs(t)<=D2*e[0]}function is(n,e){let t=n[0]===0;return t?n:be(n,t?mn:e)}function cx(n,e){let t=pn(n[0]),i=e[0]===0||pn(e[0])<2*t,s=n[0]!==0&&t<R2&&i?-t:0,r=qe(1,s),o=de(de(e,r),r);return de(Yt(Te(wn(de(n,r)),de(o,4))),qe(1,-s))}function ux(n,e,t){let i=n[0]>=0,s=de(Te(e,i?n:[-n[0],-n[1]]),.5),r=s[0]>0?is(t,s):ns;return[i?s:r,i?r:s]}function z2(n,e,t,i,s,r){let o=is(t,r),a=is(Te(s,xe(n,o)),r),l=cx(a,o),{0:c,1:u}=ux(a,l,o),h=Te(e,u),d=at(e,c),f=at(r,xe(n,e)),p=f[0]>=xe(n,d)[0],x=is(i,xe(h,p?f:d));return d=p?x:d,f=p?f:x,[u,c,l,h,d,Te(r,xe(n,u)),at(r,xe(n,c)),r,f]}function G2(n,e,t,i,s,r){let o=xe(n,r),a=is(i,o),l=be(Te(de(s,-2),is(i,r)),o),c=cx(l,a),{0:u,1:h}=ux(l,c,a),d=xe(n,h),f=Te(xe(n,e),d),p=at(e,u),x=at(r,e),m=p[0]>=x[0],g=is(is(t,f),m?p:x);return p=m?p:g,x=m?g:x,[x,p,at(r,u),r,u,xe(n,Te(r,h)),xe(n,c),f,d]}function V2(n,e,t,i){let s=n.G,r=n.s0,o=n.t0,a=wn(n.p),l=wn(n.c),c=z2(s,r,a,l,i,t),u=G2(s[0]>0?s:mn,r,a,l,n.F,t),h=e?c[1]:u[1],d=e?c[7]:u[7],f=Te(o,h),p=Te(d,xe(s,o));return{fromLower:e?c[0]:u[0],fromUpper:h,d:e?c[2]:u[2],s1:e?c[3]:u[3],s2:e?c[4]:u[4],t1:is(wn(n.cPlus),xe(f,p)),t2:f,A:e?c[5]:u[5],B:e?c[6]:u[6],Y:d,ZMinus:e?c[8]:u[8],ZPlus:p}}function hx(n){let e=F2(n),t=O2(e);for(let s=0;s<N2&&!(s>=L2&&k2(t));s++)t=B2(t);let{0:i}=t;return V2(n,e.upper,i,e.f1)}var dx=[0,0,0,0];function H2(n,e){return n.G[0]*e.d[0]<=e.B[0]}function gx(n,e,t,i){let s=n.G[0]*e.d[0]/e.A[0],r=t.separatrix?0:e.B[0]/e.A[0],o=t.permanent||H2(n,e)&&!t.separatrix,a=t.permanent?0:o?s:r,l=a*Ba(a,Math.sqrt(1-a)),c=l*l*(l*l),u=1+2*(l+c+c*c*l),h=1/(u*u),d=de(Te(i.x0,Tf(n)),n.p[0]>=0?1:-1);return{full:o,q:l,theta3:u,yAlpha:i.vAlpha*h,yBeta:i.vBeta*h,wAlpha:i.wAlpha*h,wBeta:i.wBeta*h,x0:d}}function fx(n,e,t,i,s){let r=t*i,o=t*t*i,a=t*t*t*i;o=o*o,a=a*a*a;let l=e*e*e,c=l*e*e,u=l*l*e;return n=n/(a*(1+u)+o*(1+c)+r*(1+l)+(1+e)),r=s*n*r,o=n*o,a=s*n*a,[[n*(1+e),r*(1+l),o*(1+c),a*(1+u)],[n*(1-e),r*(1-l),o*(1-c),a*(1-u)]]}function W2(n,e,t,i){let s=t*t*(t*t);return[n*i,e*(1-2*(t-s+s*s*t))]}function px(n){let{0:e,1:t}=nn(n*(.5/Math.PI)),i=2*e*t,s=1-2*e*e;return[[t,s,s*t-i*e,1-2*i*i],[e,i,i*t+s*e,2*i*s]]}function q2(n,e,t,i,s,r){let o=t*t,a=o*o,l=o*o*o,c=l*o*t,{0:u,1:h}=px(s),d=1-2*(t*u[1]-a*u[3]+c*(2*u[2]*u[2]-1)),f=n*i/d,p=u[3]*u[0]-h[3]*h[0],x=h[3]*u[0]+u[3]*h[0],m=u[3]*u[2]-h[3]*h[2],g=h[3]*u[2]+u[3]*h[2],y=[f*h[0],-f*h[2],f*x,-f*g],v=[f*u[0],-f*u[2],f*p,-f*m];return{0:u,1:h}=px(2*r),d=1-2*(t*u[0]-a*u[1]+c*u[2]),f=e*(1+o+l+l*l)/d,[y,v,[-f*u[0],f*u[1],-f*u[2],f*u[3]],[-f*h[0],f*h[1],-f*h[2],f*h[3]],f]}function Cf(n,e,t){let i=qe(1,-(Va(n)?0:n.lift)),s=Ou(n),r=Math.sqrt(.5*e[0]),o=Math.sqrt(.5*t[0]);return[r*(s?1:i),o*(s?i:1)]}function X2(n){return[Math.exp(-2*n.wAlpha),Math.exp(-2*n.yAlpha),Math.exp(-2*n.wBeta),Math.exp(-2*n.yBeta)]}function $2(n,e,t,i){let{0:s,1:r}=Cf(n,e.t2,e.s1),{0:o,1:a}=W2(s,r,t.q,t.theta3),l=t.q>0,{0:c,1:u}=fx(o,i[1],t.q,l?i[0]:0,-1),{0:h,1:d}=fx(a,i[3],t.q,l?i[2]:0,1);return[c,u,h,d,0]}function Y2(n){return $2(n.top,n.points,n.at,X2(n.at))}function Z2(n){let{0:e,1:t}=Cf(n.top,n.top.t0,n.top.s0);return[[e,0,0,0],dx,dx,[t,0,0,0],0]}function j2(n){return n.rates.permanent?Z2(n):Y2(n)}function K2(n,e,t){let{0:i,1:s}=Cf(n,e.t2,e.s1);return q2(i,s,t.q,t.theta3,t.yAlpha,t.yBeta)}function J2(n){return K2(n.top,n.points,n.at)}function mx(n,e,t,i,s,r,o,a,l,c,u,h){n=n/l,e=e/l;let d=u*(t/l-n*c)-r*e,f=u*(i/l-e*c)+r*n,{0:p,1:x}=o,{0:m,1:g}=a,y=n*p+e*x+(d*m+f*g)/h,v=n*x-e*p+(d*g-f*m)/h,{0:M,1:w}=nn(s-Ct(s));({0:y,1:v}=[y*w+v*M,v*w-y*M]);let E=Math.sqrt(y*y+v*v),_=E>0,b=_?E:1;return[_?y/b:1,_?v/b:0]}function Q2(n,e,t,i,s,r,o){let{0:a,1:l,2:c}=t,u=Ns(e),h=be([n[0],0],u)[0],d=be([n[1],0],u)[0],f=be([n[2],0],u)[0],p=be([n[3],0],u)[0],x=[.5*(-c*p-(a*d+l*f)),.5*(c*h-(a*f-l*d))],m=[.5*(a*h-l*p+c*f),.5*(a*p+l*h-c*d)],{0:g,1:y,2:v,3:M,4:w,5:E,6:_,7:b,8:I,9:T}=s,L=g*g+y*y+(v*v+M*M),D=Math.sqrt(L),B=(g*w+y*E+(v*_+M*b))/L,{0:P,1:O}=mx(g,y,w,E,I,r[0],[h,p],x,D,B,o,i),{0:H,1:V}=mx(v,M,_,b,T,r[1],[d,f],m,D,B,o,i);return[P,O,H,V]}function eR(n,e,t){let{0:i,1:s,2:r,3:o,4:a,5:l,6:c,7:u,8:h,9:d}=t,f=qe(1,n.lift),p=Ou(n),x=p?1:f,m=p?f:1,{0:g,1:y,2:v}=n.momentum,M=g*g+y*y+(v*v+n.G[0]),w=[i*x,s*x,r*m,o*m,a*x,l*x,c*m,u*m,h,d];return Q2(n.quaternion,n.size,n.momentum,M>0?M:1,w,e.linear,e.turn)}function Rf(n){let{0:e,1:t}=Sn(n[0]);return[e,t,n[1]]}function tR(n,e,t){let{0:i}=n.moments,s=e.permanent,r=e.separatrix,o=t.full,{0:a,1:l}=ax(n,e),c=nx(e.nutation,i,n.rateScale),u=be(de(e.halfRoot,n.rateScale),[i,0]),h=s?ns:o?de(c,.5):r?u:c,{0:d,1:f}=ix(e.halfRoot,e.nutation,t.q),p=de(be(t.x0,d),.5),x=o?de(p,.5):r?t.x0:p;x=s?[.25,0]:x,f=r?mn:f;let{0:m,1:g}=Sn(f[0]),y=o||r?0:t.yAlpha,v=o||r?0:t.yBeta,M=e.nutation[0]*(2/Math.PI),w=e.signAlpha,E=e.signBeta,_=o?e.nutation[0]:e.halfRoot[0]/(t.theta3*t.theta3),b=s?0:e.alpha[0]+w*y*M,I=s?0:e.beta[0]+E*v*M;_=s?0:_;let T=n.momentumScale;return{rates:[Rf(a),Rf(l),Rf(h),x],places:[[t.q,m,g+f[1],y/Math.PI,v/Math.PI,r?0:1],[s?1:w,s?1:E],[2*_*T,2*(b+I)*T]],linear:[b,I],turn:_}}function xx(n,e,t,i){let{0:s,1:r,2:o,3:a}=e.rates,{0:l,1:c,2:u}=e.places,{0:h,1:d,2:f,3:p,4:x}=t;return{full:n.at.full?1:0,first:s,second:r,third:o,start:a,aSum:h,aGap:d,bSum:f,bGap:p,constant:x,nome:l,signs:c,rates:u,phases:i,axial:n.axial,reversed:n.top.reversed?-1:1}}function nR(n){let e=tR(n.top,n.rates,n.at),t=n.at.full?j2(n):J2(n);return[xx(n,e,t,[1,0,1,0]),e]}function iR(n){let e=0*n.start[0];return Sf(n,[e,e,e])}function sR(n){let e=0*n.start[0],{0:t,1:i,2:s,3:r,4:o,5:a,6:l}=wf(n,[e,e,e]);return Af(n,t,i,s,Math.exp(r)*o,Math.exp(a)*l)}function rR(n,e,t){let i=n.at.full?iR(e):sR(e),s=[e.aSum,e.aGap,e.bSum,e.bGap,e.constant];return xx(n,t,s,eR(n.top,t,i))}function yx(n){let{0:e,1:t}=nR(n);return rR(n,e,t)}var oR=["rest","sleeping","hanging","steady","free","planar","undulating","cusp","loop","separatrix"],Ha=class{constructor({moments:e,mgl:t,momentum:i,attitude:s=[1,0,0,0],epoch:r=0}){if(this.moments=ro(e),this.moments[0]!==this.moments[1])throw new RangeError(`\`moments\` must be (I1, I1, I3), the first two equal; got ${JSON.stringify(this.moments)} kg m\xB2. Give one of them twice if they differ by rounding, and put the axis of symmetry third.`);this.mgl=wt("mgl",t,"N m"),this.momentumAtEpoch=An("momentum",i,3,"kg m\xB2/s"),this.attitudeAtEpoch=oo(s),this.epoch=wt("epoch",r,"seconds");let o=this.momentumAtEpoch,a=q0(this.moments,this.mgl,o,this.attitudeAtEpoch),l=hx(a),c=ox(a,l),u=Math.max(...o.map((I,T)=>Math.abs(I/this.moments[T])));this._fastest=u+Math.sqrt(Math.abs(this.mgl)/this.moments[0]);let h=gx(a,l,c,K0(a,l,c));this._motion=yx({top:a,points:l,rates:c,at:h,axial:o[2]});let{first:d,second:f,third:p,start:x,rates:m,phases:g}=this._motion;_u([this._fastest,...d,...f,...p,...x,...m,...g]);let[y,v,M,w]=this.attitudeAtEpoch,[E,_]=[y*y+w*w,v*v+M*M],b=.5*o.reduce((I,T,L)=>I+T/this.moments[L]*T,0);this.energy=b+this.mgl*(E-_)/(E+_),this.verticalMomentum=Ca(ao(this.attitudeAtEpoch),o)[2],this.axialMomentum=o[2],Object.assign(this,aR(a,l,c))}state(e){let[t,i]=yu(e,this.epoch,this._fastest);return vu(W0(this._motion,t,i))}angularVelocity(e){let t=this.state(e).momentum;return[t[0]/this.moments[0],t[1]/this.moments[1],t[2]/this.moments[2]]}};function aR(n,e,t){let i=Q0(n,e,t);return{regime:oR[i.regime],nutationLimits:[i.lowest,i.highest],nutationPeriod:Hn(i.period),precessionPerPeriod:Hn(i.precessionPerPeriod),spinPerPeriod:Hn(i.spinPerPeriod),precessionRate:Hn(i.precessionPerPeriod/i.period),spinRate:Hn(i.spinPerPeriod/i.period)}}var _x=Math.PI/180,[lR,cR,uR]=[45,60,20],Pf="turns over and over",hR=.995,dR=!0,fR=["spin.tilt","spin.rate","spin.about"],pR={body:{moments:3},spin:Us};function mR({moments:n,momentum:e,attitude:t=[1,0,0,0],epoch:i=0,mass:s}){let r=e.map((a,l)=>a/n[l]),o=Fs(r);return{moments:n,velocity:r,attitude:t,epoch:i,about:o,around:sn(r,o).around,momentum:e,mass:s??1}}function gR(n){let e=vx(n);return[...e?[{key:"by",label:"set the body by",value:n.by??0,choices:[[0,"its moments"],[1,"the edges of a box"]]}]:[],...e&&n.by?xR(n,e):Os(n.moments),...Bs(n)]}function xR({mass:n=1},e){let t=Math.max(...e),[i,s]=[["km",1e3],["m",1],["cm",.01],["mm",.001],["\xB5m",1e-6],["nm",1e-9]].find(([,r])=>t>=r)??["m",1];return[{key:"mass",label:"mass of the box",unit:"kg",value:n,log:!0,low:n/20,high:20*n},...e.map((r,o)=>({key:`edge.${o}`,label:W("edge along axis {axis}",{axis:o+1}),unit:i,si:s,value:r,log:!0,low:Math.max(r,.001*t)/10,high:10*Math.max(r,.001*t)}))]}function vx({moments:n,mass:e=1}){let t=n[0]+n[1]+n[2],i=n.map(s=>6/e*(t-2*s));return i.every(s=>s>=0&&Number.isFinite(s))?i.map(Math.sqrt):null}function yR(n,e,t){let[i,s]=e.split(".");if(i==="by")return{...n,by:t};if(i!=="edge"&&i!=="mass")return ks(n,e,t);let r=vx(n),o=i==="mass"?t:n.mass??1;i==="edge"&&(r[Number(s)]=t);let a=r.map(c=>c*c),l=[0,1,2].map(c=>o/12*(a[(c+1)%3]+a[(c+2)%3]));return{...n,mass:o,moments:l,momentum:null}}function _R(n,e){let t=Math.hypot(...n.velocity.map((r,o)=>r*n.moments[o])),i=e.map(r=>r*t),s=i.map((r,o)=>r/n.moments[o]);return{...n,velocity:s,momentum:i,around:sn(s,n.about).around}}var vR=n=>new yi({moments:n.moments,momentum:ri(n),attitude:n.attitude,epoch:n.epoch});function MR({moments:n,velocity:e,attitude:t}){return{body:{moments:n},spin:{angular_velocity:e,attitude:t}}}var bR=(n,e)=>zs(n,e);function SR({moments:n,velocity:e,attitude:t},i){return`[body]
moments = ${Wn(n,"kg*m^2")}

[spin]
angular_velocity = ${Wn(e,"rad/s")}
attitude = [${t.map(He).join(", ")}]

[time]
until = "${He(i)} s"
`}function wR({moments:n,velocity:e},t){let i=si(n),{period:s,regime:r}=t,o=s!==null&&Number.isFinite(s),a=Mx(n,e,t,i),l=[["what it does",a]];return o&&l.push(["period of L in the body",En(s,s)]),o&&t.precessionPerPeriod!==null&&l.push(["precession about L",W("{angle} per period",{angle:`${et(t.precessionPerPeriod/_x,5)}\xB0`})]),a===Pf&&Number.isFinite(t.flipInterval??NaN)&&l.push(["turns over every",En(t.flipInterval,t.flipInterval)]),l.push(["regime",r]),l}function AR({moments:n,velocity:e},t){let{period:i,flipInterval:s}=t;return i===null||!Number.isFinite(i)?null:Mx(n,e,t,si(n))===Pf?s:i}function Mx(n,e,{regime:t,modulus:i},s){if(t==="rest")return"at rest";if(t==="separatrix")return"runs up to the intermediate axis and stays there";if(t==="permanent"||t==="spherical")return"spins steadily";let[r,o]=ER(n,e,s),l=Number(r.toPrecision(3))===Number(o.toPrecision(3))?If(o):W("{least} to {most}",{least:If(r),most:If(o)});return o<lR?W("cones, its axis {angle} from L",{angle:l}):o>=cR&&(o-r>=uR||i>hR)?Pf:W("tumbles, its axis {angle} from L",{angle:l})}function If(n){let[e,t]=[[1,"\xB0"],[.016666666666666666,"\u2032"],[.0002777777777777778,"\u2033"],[27777777777777776e-23," mas"]].find(([i])=>n>=i)??[1,"\xB0"];return`${et(n/e,3)}${t}`}function ER(n,e,t){let[i,s,r]=t.map(m=>n[m]),o=t.map(m=>e[m]*n[m]),a=Math.hypot(...o),[l,c,u]=o.map(m=>Math.abs(m)/a),h=i===r||i*(r-s)*u*u>=r*(s-i)*l*l,d=h?i*(r-s)/(s*(r-i)):r*(s-i)/(s*(r-i)),f=h?l:u,p=Math.sqrt(f*f+(d||0)*c*c),x=Math.min(1,d>0?p/Math.sqrt(d):1);return i===r?[0,0]:[Math.asin(Math.min(p,x)),Math.asin(Math.max(p,x))].map(m=>m/_x)}var Nf={};ps(Nf,{asSpec:()=>FR,changed:()=>DR,controls:()=>NR,facts:()=>GR,first:()=>RR,from:()=>IR,kept:()=>Gu,keys:()=>CR,make:()=>UR,spinAboutRotor:()=>wx,toml:()=>kR,withSpec:()=>OR});var TR=Math.PI/30,sk=Math.PI/180,RR=["rate","rotor","spin.tilt","spin.rate"],CR={body:{moments:3},system:{kind:0,rotor_axis:3,rotor_moment:1,rotor_rate:1,rotor_drive:0,rotor_momentum:1},spin:Us};function IR({moments:n,rotor:e,rotor_moment:t=null,rotor_drive:i="constant-rate",momentum:s,attitude:r=[1,0,0,0],epoch:o=0}){let a=s.map((d,f)=>(d-e[f])/n[f]),l=Fs(a),c=Math.hypot(...e),u=c>0?e.map(d=>d/c):[0,0,1],h=sn(a,l).around;return{moments:n,velocity:a,attitude:r,epoch:o,about:l,around:h,momentum:s,axis:u,spin:c,moment:t,drive:i}}var PR=1e-9,LR={momentum_space:"L in space"},ku=({axis:n,spin:e})=>n.map(t=>t*e),bx=({axis:n,drive:e,velocity:t})=>e==="free"?n.reduce((i,s,r)=>i+s*t[r],0):0,zu=n=>n.spin/n.moment-bx(n),Sx=(n,e)=>({...n,spin:n.moment*(e+bx(n)),momentum:null});function NR(n){let e=Math.max(Math.abs(n.spin),Math.hypot(...ri(n,ku(n))))||1;return[n.moment===null?{key:"rotor",label:"momentum of the rotor",unit:"kg m\xB2/s",value:n.spin,low:-2*e,high:2*e}:{key:"rate",label:"rotor speed against the body",unit:"rpm",si:TR,value:zu(n),low:-2*e/n.moment,high:2*e/n.moment},...Os(n.moments),...Bs(n)]}function DR(n,e,t){return e==="rotor"?{...n,spin:t,momentum:null}:e==="rate"?Sx(n,t):ks(n,e,t)}var UR=n=>new La({moments:n.moments,rotor:ku(n),rotor_moment:n.moment,rotor_drive:n.drive,axis:n.axis,momentum:ri(n,ku(n)),attitude:n.attitude,epoch:n.epoch}),FR=n=>({body:{moments:n.moments},system:n.moment===null?{kind:"gyrostat",rotor_axis:n.axis,rotor_momentum:n.spin}:{kind:"gyrostat",rotor_axis:n.axis,rotor_moment:n.moment,rotor_rate:zu(n),rotor_drive:n.drive},spin:{angular_velocity:n.velocity,attitude:n.attitude}});function OR(n,e){let{system:t={}}=e,i={...n};if(t.rotor_axis){let a=Math.hypot(...t.rotor_axis);if(!(a>0))throw new RangeError("system.rotor_axis must have a direction; got zeros.");Object.assign(i,{axis:t.rotor_axis.map(l=>l/a),momentum:null})}let s=[t.rotor_rate,t.rotor_moment,t.rotor_drive].some(a=>a!==void 0),r=t.rotor_rate??(i.moment===null?null:zu(i));if(t.rotor_moment!==void 0&&Object.assign(i,{moment:t.rotor_moment,momentum:null}),t.rotor_drive!==void 0&&Object.assign(i,{drive:t.rotor_drive,momentum:null}),t.rotor_momentum!==void 0&&Object.assign(i,{spin:t.rotor_momentum,momentum:null}),s&&i.moment===null)throw new RangeError("system.rotor_rate needs system.rotor_moment, the rotor's own moment of inertia.");let o=s?e.spin?.momentum:null;return o&&(i.spin=BR(i,r,e.body?.moments??i.moments,o)),i=zs(i,e,ku(i)),s&&!o&&r!==null?Sx(i,r):i}function BR({axis:n,moment:e,drive:t},i,s,r){if(t!=="free")return e*i;let o=a=>n.reduce((l,c,u)=>l+c*a[u]/s[u],0);return e*(i+o(r))/(1+e*o(n))}function kR(n,e){let{axis:t,moment:i,drive:s,velocity:r,attitude:o}=n,a=t.findIndex(c=>Math.abs(c)===1);if(i===null||s==="free"&&a<0)return null;let l=n.moments.map((c,u)=>s==="free"&&u===a?c+i:c);return`[body]
moments = ${Wn(l,"kg*m^2")}

[system]
kind = "gyrostat"
rotor_axis = [${t.map(He).join(", ")}]
rotor_moment = "${He(i)} kg*m^2"
rotor_rate = "${He(zu(n))} rad/s"
rotor_drive = "${s}"

[spin]
angular_velocity = ${Wn(r,"rad/s")}
attitude = [${o.map(He).join(", ")}]

[time]
until = "${He(e)} s"
`}var zR={minimum:"stable, also with losses in the body: least energy",maximum:"stable until losses act: most energy",saddle:"unstable: a saddle of the energy"};function GR(n,e){let t=e.state(e.epoch),i=Math.hypot(...t.momentum),s=Fa(t.attitude,t.momentum).map(o=>o/(i||1)),r=[];if(i>0){let{least:o,most:a,around:l}=Cu(e,({attitude:u})=>Fa(u,n.axis),s);r.push(["rotor's axis leans from L",Ru(o,a)]),r.push(["precession of the rotor's axis about L",xi(l)]);let c=wx(n,i);c&&(r.push(["a spin about the rotor's axis",zR[c.extremum]]),c.nutation&&r.push(["nutation: L goes round it in the body every",En(2*Math.PI/c.nutation,2*Math.PI/c.nutation)]))}return[...r,...Gu(e)]}function wx({moments:n,axis:e,spin:t},i){let s=e.findIndex(l=>Math.abs(Math.abs(l)-1)<PR);if(s<0)return null;let r=(i-t)/n[s],[o,a]=[1,2].map(l=>i/n[(s+l)%3]-r);return{extremum:o*a<=0?"saddle":o>0?"minimum":"maximum",nutation:o*a>0?Math.sqrt(o*a):null}}function Gu(n){let e=n.state(n.epoch),t=Math.hypot(...e.velocity)||1,i=n.state(n.epoch+40*Math.PI/t);return Object.entries(e.invariants).map(([s,r])=>{let[o,a]=[[r].flat(),[i.invariants[s]].flat()],l=Math.hypot(...o)||1;return[W("{quantity}, change in 20 turns",{quantity:W(LR[s]??s)}),et(Math.hypot(...o.map((c,u)=>c-a[u]))/l,2)]})}var Df={};ps(Df,{asSpec:()=>KR,changed:()=>ZR,controls:()=>YR,facts:()=>eC,first:()=>qR,from:()=>$R,keys:()=>XR,make:()=>jR,standsUpright:()=>Ex,toml:()=>QR,withSpec:()=>JR});var Ax=9.80665,VR=Math.PI/180,HR=1e-5,WR=.01*VR,qR=["spin.rate","spin.tilt","mgl"],XR={system:{kind:0,moments:3,mgl:1,axis:3},spin:Us};function $R({moments:n,mgl:e,axis:t,momentum:i,attitude:s=[1,0,0,0],epoch:r=0}){let o=i.map((l,c)=>l/n[c]),a=Fs(o);return{moments:n,velocity:o,attitude:s,epoch:r,about:a,around:sn(o,a).around,momentum:i,mgl:e,axis:t}}var YR=n=>[{key:"mgl",label:"weight \xD7 distance to the centre of mass",unit:"N m",value:n.mgl,low:0,high:5*Math.abs(n.mgl)||1},...Os(n.moments),...Bs(n)],ZR=(n,e,t)=>e==="mgl"?{...n,mgl:t}:ks(n,e,t),jR=n=>new Na({...n,momentum:ri(n)}),KR=({moments:n,mgl:e,axis:t,velocity:i,attitude:s})=>({system:{kind:"heavy-top",moments:n,mgl:e,axis:t},spin:{angular_velocity:i,attitude:s}});function JR(n,e){let{system:t={}}=e,i={...n};return t.mgl!==void 0&&(i.mgl=Number(t.mgl)),t.axis&&(i.axis=t.axis.map(Number)),zs(i,t.moments?{...e,body:{moments:t.moments}}:e)}function QR(n,e){let{moments:t,mgl:i,axis:s,velocity:r,attitude:o}=n,a=Math.hypot(...s),l=s.map(x=>x/a),c=[0,1,2].map(x=>.5*(t[0]+t[1]+t[2])-t[x]),u=l.reduce((x,m,g)=>x+(m?m*m/c[g]:0),0);if(i&&!(u>0&&Number.isFinite(u)))return null;let h=i?.5/u:0,d=i?h*Ax/i:0,f=i?i/(Ax*d):1,p=[0,1,2].map(x=>[0,1,2].map(m=>(x===m?t[x]-h:0)+h*l[x]*l[m]));return`# a body with the moments ${t.map(x=>et(x)).join(", ")} kg m\xB2 about its point, and mgl = ${et(i)} N m
[body]
mass = "${He(f)} kg"
inertia = [${p.map(x=>Wn(x,"kg*m^2")).join(", ")}]

[system]
kind = "heavy-top"
pivot = ${Wn(l.map(x=>-d*x),"m")}

[spin]
angular_velocity = ${Wn(r,"rad/s")}
attitude = [${o.map(He).join(", ")}]

[time]
until = "${He(e)} s"
`}function eC({moments:n,mgl:e,axis:t,velocity:i},s){let r=Math.hypot(...t),o=t.map(f=>f/r),{least:a,most:l,swing:c,around:u}=Cu(s,({attitude:f})=>Fa(f,o)),h=[["axis leans",Ru(a,l)]];c!==null&&l-a>WR&&h.push(["nutation: nods every",En(c,c)]),h.push(["mean precession",xi(u)]);let d=o.findIndex(f=>Math.abs(Math.abs(f)-1)<HR);if(d>=0){let f=i[d]*o[d];f&&e&&h.push(["a gyroscope's, mgl/I\u2083\u03C9",xi(e/(n[d]*f))]),h.push(["upright at this spin, to first order",Ex(n,e,d,f)?"stable: it would sleep":"unstable: it would fall"])}return[...h,...Gu(s)]}function Ex(n,e,t,i){let[s,r,o]=[n[(t+1)%3],n[(t+2)%3],n[t]],[a,l]=[(o-r)*i*i-e,(o-s)*i*i-e],[c,u,h]=[s*r,s*l+r*a+((s+r-o)*i)**2,a*l];return u>0&&h>0&&u*u>4*c*h}var Ff={};ps(Ff,{asSpec:()=>hC,changed:()=>cC,controls:()=>lC,facts:()=>mC,first:()=>rC,from:()=>aC,keys:()=>oC,make:()=>uC,toml:()=>fC,withSpec:()=>dC});var tC=Math.PI/30,nC=Math.PI/180,Tx=9.80665,iC=1e-6,sC=1e-9,rC=["lean","spin","precession"],oC={system:{kind:0,moments:3,mgl:1,lean:1},spin:{spin:1,precession:1,nutation_rate:1,lean:1,momentum:3,attitude:4}};function aC({moments:n,mgl:e,momentum:t,attitude:i=[1,0,0,0],epoch:s=0}){return{moments:n,mgl:e,...Uf(n,t,i),momentum:t,attitude:i,epoch:s}}function Uf(n,e,[t,i,s,r]){let o=e.map((p,x)=>p/n[x]),a=[2*(i*r-t*s),2*(s*r+t*i),t*t-i*i-s*s+r*r],l=Math.hypot(a[0],a[1]),c=2*Math.atan2(Math.hypot(i,s),Math.hypot(t,r));if(l<sC)return{lean:c<1?0:Math.PI,spin:o[2],precession:0,nutation:0,phi:2*Math.atan2(r,t),psi:0};let u=Math.atan2(r,t),h=Math.atan2(s,i),d=(o[0]*a[0]+o[1]*a[1])/l**2,f=(o[0]*a[1]-o[1]*a[0])/l;return{lean:c,precession:d,nutation:f,spin:o[2]-d*Math.cos(c),phi:u+h,psi:u-h}}function Rx({moments:n,lean:e,spin:t,precession:i,nutation:s,phi:r,psi:o}){let[a,l]=[Math.cos(.5*e),Math.sin(.5*e)],[c,u]=[.5*(r+o),.5*(r-o)],h=[a*Math.cos(c),l*Math.cos(u),l*Math.sin(u),a*Math.sin(c)],d=[i*Math.sin(e)*Math.sin(o)+s*Math.cos(o),i*Math.sin(e)*Math.cos(o)-s*Math.sin(o),i*Math.cos(e)+t];return{attitude:h,momentum:d.map((f,p)=>f*n[p])}}function lC(n){let{moments:e,mgl:t,lean:i,spin:s,precession:r,nutation:o}=n,a=Math.max(Math.abs(s),Math.abs(r),Math.sqrt(Math.abs(t)/e[0]),1e-6),l={unit:"rpm",si:tC,low:-5*a,high:5*a};return[{key:"moments.0",label:"moment of inertia across, at the point",unit:"kg m\xB2",value:e[0],log:!0,low:Math.max(e[0]/10,.5*e[2]),high:10*e[0]},{key:"moments.2",label:"moment of inertia about the axis",unit:"kg m\xB2",value:e[2],log:!0,low:e[2]/10,high:Math.min(10*e[2],2*e[0])},{key:"mgl",label:"weight \xD7 distance to the centre of mass",unit:"N m",value:t,low:0,high:5*Math.abs(t)||1},{key:"lean",label:"lean",unit:"\xB0",si:nC,value:i,low:0,high:Math.PI},{key:"spin",label:"spin about its axis",value:s,...l},{key:"precession",label:"precession at the start",value:r,...l},{key:"nutation",label:"nutation at the start",value:o,...l}]}function cC(n,e,t){let i={...n};return e==="moments.0"?i.moments=[t,t,n.moments[2]]:e==="moments.2"?i.moments=[n.moments[0],n.moments[1],t]:i[e]=t,{...i,...Rx(i)}}function uC({moments:n,mgl:e,momentum:t,attitude:i,epoch:s}){return new Ha({moments:n,mgl:e,momentum:t,attitude:i,epoch:s})}function hC({moments:n,mgl:e,attitude:t,lean:i,spin:s,precession:r,nutation:o}){return{system:{kind:"lagrange-top",moments:n,mgl:e,lean:i},spin:{spin:s,precession:r,nutation_rate:o,attitude:t}}}function dC(n,{system:e={},spin:t={}}){let i={...n};if(e.moments&&(i.moments=e.moments.map(Number)),e.mgl!==void 0&&(i.mgl=Number(e.mgl)),t.attitude){let o=t.attitude.map(Number),a=(t.momentum??n.momentum).map(Number);i={...i,...Uf(i.moments,a,o),attitude:o,momentum:a}}else if(t.momentum){let o=t.momentum.map(Number);return{...i,...Uf(i.moments,o,i.attitude),momentum:o}}let s={lean:e.lean??t.lean,spin:t.spin,precession:t.precession,nutation:t.nutation_rate},r=Object.entries(s).filter(([,o])=>o!==void 0);if(!r.length&&!e.moments)return i;for(let[o,a]of r)i[o]=Number(a);return{...i,...Rx(i)}}function fC(n,e){let{moments:t,mgl:i,attitude:s,momentum:r}=n,o=.5*Math.min(.5*t[0],t[0]-.5*t[2]),a=o>0&&i?(i/Tx)**2/o:1,l=i/(a*Tx),c=t[0]-a*l*l,u=r.map((h,d)=>h/t[d]);return`# a body with these moments about its point, ${et(t[0])} and ${et(t[2])} kg m\xB2, and mgl = ${et(i)} N m
[body]
mass = "${He(a)} kg"
moments = ["${He(c)} kg*m^2", "${He(c)} kg*m^2", "${He(t[2])} kg*m^2"]

[system]
kind = "lagrange-top"
pivot = ["0 m", "0 m", "${He(-l)} m"]

[spin]
angular_velocity = [${u.map(h=>`"${He(h)} rad/s"`).join(", ")}]
attitude = [${s.map(He).join(", ")}]

[time]
until = "${He(e)} s"
`}var pC={rest:"at rest",sleeping:"stands upright and spins",hanging:"hangs and spins",steady:"goes round at constant lean",free:"no weight: turns freely",planar:"swings like a pendulum",undulating:"nods while it goes round, always onward",cusp:"nods, halting at cusps",loop:"nods in loops",separatrix:"rises to the vertical and stays there"};function mC({moments:n,spin:e,mgl:t},i){let[s,r]=i.nutationLimits??[0,1],o=r-s<iC&&i.regime==="undulating"?"steady":i.regime,a=[["what it does",pC[o]??o]],l=i.nutationPeriod,c=l!==null&&Number.isFinite(l);return c&&o!=="steady"&&a.push(["nods every",En(l,l)]),c&&i.precessionPerPeriod!==null&&i.regime!=="planar"&&a.push(["mean precession",xi(i.precessionPerPeriod/l)]),e&&t&&a.push(["a gyroscope's, mgl/I\u2083\u03C9",xi(t/(n[2]*e))]),t>0&&a.push(["sleeps upright from",xi(2*Math.sqrt(t*n[0])/n[2])]),a}var kf={};ps(kf,{QuantumMotion:()=>qu,asSpec:()=>HC,changed:()=>kC,controls:()=>BC,dragged:()=>DC,facts:()=>qC,first:()=>UC,from:()=>OC,keys:()=>FC,make:()=>VC,withDirection:()=>zC,withSpec:()=>WC});var Ix=2*Math.PI,gC=.5*(Math.sqrt(5)-1),xC=1-1e-15,Px=1e-12;function yC(n,e){let[t,i]=[1,Math.sqrt(1-e)],s=[];for(;t-i>Px*t;){let[a,l]=[.5*(t+i),.5*(t-i)];i=Math.sqrt(t*i),t=a,s.push(l/a)}let r=2**s.length*t*n;for(let a of s.reverse())r=.5*(r+Math.asin(a*Math.sin(r)));let o=Math.sin(r);return[o,Math.cos(r),Math.sqrt(1-e*o*o)]}function _C(n,e){let[t,i,s,r]=[1,Math.sqrt(1-e),n,1];for(;t-i>Px*t;){let o=Math.round(s/Math.PI)*Math.PI;s+=Math.atan(i/t*Math.tan(s-o))+o,[t,i,r]=[.5*(t+i),Math.sqrt(t*i),2*r]}return s/(r*t)}var Of=class{constructor([e,t,i],s,r){let[o,a,l]=r;this.unit=r,this.aboveSaddle=(e-t)*o*o>(t-i)*l*l;let c=(e-i)*o*o+(t-i)*a*a,u=(e-t)*a*a+(e-i)*l*l;if(!(u>0)||!(c>0)){this.rate=0;return}let[h,d]=this.aboveSaddle?[c,u]:[u,c],[f,p]=this.aboveSaddle?[e-t,t-i]:[t-i,e-t];this.m=Math.min(xC,p*d/(f*h)),this.rate=2*Ix*s*Math.sqrt(f*h);let x=this.aboveSaddle?o:l;this.sign=x<0?-1:1,this.long=this.sign*Math.sqrt(h/(e-i)),this.middle=this.sign*Math.sqrt(d/f),this.short=Math.sqrt(d/(e-i)),this.phase=_C(Math.atan2(a/this.middle,(this.aboveSaddle?l:o)/this.short),this.m)}at(e){if(!this.rate)return this.unit;let[t,i,s]=yC(this.rate*e+this.phase,this.m),[r,o,a]=[this.long*s,this.middle*t,this.short*i];return this.aboveSaddle?[r,o,a]:[a,o,r]}};function Lx(n,e,t,i){let s=Math.abs(t[0])<.6?[1,0,0]:[0,0,1],r=Wa(Cx(t,s)),o=Cx(t,r);return Array.from({length:i},(a,l)=>{let c=((l+.5)/i)**(1/(4*e+1)),u=2*Math.asin(Math.sqrt(1-c)),h=Ix*(l*gC%1),[d,f,p]=[Math.sin(u)*Math.cos(h),Math.sin(u)*Math.sin(h),Math.cos(u)];return new Of(n,e+.5,Wa(t.map((x,m)=>d*r[m]+f*o[m]+p*x)))})}var Cx=(n,e)=>[0,1,2].map(t=>n[(t+1)%3]*e[(t+2)%3]-n[(t+2)%3]*e[(t+1)%3]),Wa=n=>n.map(e=>e/Math.hypot(...n));var vC=4,MC=1e-13,Dx=(n,e,t,i,s)=>{let r=1-s;return n.clone().multiplyScalar(r*r*(1+2*s)).addScaledVector(e,s*s*(3-2*s)).addScaledVector(t,s*r*r).addScaledVector(i,-s*s*r)},Nx=(n,e,t)=>n+t*(e-n);function Ux(n,e,t,i,s){let r=p=>new C(...n.map((x,m)=>p.getComponent(m)/x)),[o,a]=[r(e.momentum),r(t.momentum)],l=(p,x)=>p.clone().cross(x).multiplyScalar(i),c=Dx(e.momentum,t.momentum,l(e.momentum,o),l(t.momentum,a),s),u=bC(n,e.momentum,t.momentum,c,s);if(!e.attitude)return{momentum:u,attitude:null};let h=SC(e.attitude,t.attitude,o.multiplyScalar(i),a.multiplyScalar(i),s),d=e.momentum.clone().applyQuaternion(e.attitude);d.lerp(t.momentum.clone().applyQuaternion(t.attitude),s).normalize();let f=u.clone().applyQuaternion(h).normalize();return{momentum:u,attitude:new rt().setFromUnitVectors(f,d).multiply(h)}}function bC(n,e,t,i,s){let r=Nx(e.length(),t.length(),s);if(!(r>0))return i;let o=Math.min(...n),a=new C(...n.map(h=>o/h)),l=h=>h.clone().multiply(a).dot(h),c=Nx(l(e.clone().divideScalar(r)),l(t.clone().divideScalar(r)),s),u=i.clone().divideScalar(r);for(let h=0;h<vC;h++){let d=u.clone().multiply(a),[f,p,x]=[u.dot(u),u.dot(d),d.dot(d)],m=f*x-p*p;if(m<MC)return u.normalize().multiplyScalar(r);let[g,y]=[.5*(1-f),.5*(c-p)];u.addScaledVector(u.clone(),(g*x-y*p)/m).addScaledVector(d,(y*f-g*p)/m)}return u.multiplyScalar(r)}function SC(n,e,t,i,s){let r=n.clone().invert().multiply(e);r.w<0&&r.set(-r.x,-r.y,-r.z,-r.w);let o=new C(r.x,r.y,r.z),a=o.length(),l=2*Math.atan2(a,r.w),c=o.multiplyScalar(a>0?l/a:2),u=l>.001?1/l**2-1/(2*l*Math.tan(l/2)):1/12,h=c.clone().cross(i),d=i.clone().addScaledVector(h,.5).addScaledVector(c.clone().cross(h),u),f=Dx(new C,c,t,d,s),p=f.length();return p>0?n.clone().multiply(new rt().setFromAxisAngle(f.divideScalar(p),p)):n.clone()}var wC=.08,AC=24e3,EC={f8:Float64Array,f4:Float32Array,u4:Uint32Array,u2:Uint16Array,u1:Uint8Array};function ht(n){if(!n)return null;let e=atob(n.data),t=new Uint8Array(e.length);for(let i=0;i<e.length;i++)t[i]=e.charCodeAt(i);return new EC[n.kind](t.buffer)}var Vu=class{constructor(e){this.times=ht(e.times),this.attitudes=ht(e.attitude),this.momenta=ht(e.momentum),this.velocities=ht(e.velocity),this.energies=ht(e.energy),this.joined=e.joined,this.space=new rt(e.space[1],e.space[2],e.space[3],e.space[0]),this.count=this.times.length,this.fastest=TC(this.velocities),this.free=e.free,this.fine=this.finely()}finely(){if(!this.joined||!this.free||!this.momenta)return 1;let e=0;for(let i=1;i<this.count;i++)e=Math.max(e,this.times[i]-this.times[i-1]);let t=Math.ceil(this.fastest*e/wC);return Math.max(1,Math.min(t,Math.floor(AC/this.count)))}get states(){return this.dense??=Array.from({length:(this.count-1)*this.fine+1},(e,t)=>this.at(t/this.fine)),this.dense}get span(){return this.times[this.count-1]-this.times[0]}attitude(e){let[t,i,s,r]=this.attitudes.subarray(4*e,4*e+4);return new rt(i,s,r,t)}at(e){let t=Math.min(Math.floor(e),this.count-1),i=this.joined&&t+1<this.count?e-t:0,s=a=>i?a[t]+i*(a[t+1]-a[t]):a[t],r=a=>{if(!a)return null;let l=new C().fromArray(a,3*t);return i?l.lerp(new C().fromArray(a,3*t+3),i):l},o={position:t+i,time:s(this.times),attitude:this.attitudes?this.attitude(t):null,momentum:r(this.momenta),velocity:r(this.velocities),energy:this.energies?s(this.energies):null};return i&&this.free&&this.momenta?Object.assign(o,this.freely(t,i)):i&&this.attitudes&&o.attitude.slerp(this.attitude(t+1),i),o}freely(e,t){let[i,s]=[e,e+1].map(a=>({momentum:new C().fromArray(this.momenta,3*a),attitude:this.attitudes?this.attitude(a):null})),r=Ux(this.free,i,s,this.times[e+1]-this.times[e],t),o=new C(...this.free.map((a,l)=>r.momentum.getComponent(l)/a));return{...r,velocity:this.velocities?o:null}}positionOf(e){let t=0,i=this.count-1;for(;i-t>1;){let r=t+i>>1;this.times[r]<=e?t=r:i=r}if(e>=this.times[i])return i;let s=this.times[i]-this.times[t];return t+(s>0?Math.max(0,(e-this.times[t])/s):0)}};function TC(n){let e=0;for(let t=0;n&&t<n.length;t+=3)e=Math.max(e,Math.hypot(n[t],n[t+1],n[t+2]));return e}var RC=2*Math.PI,Hu=class{constructor({J:e,energies:t,vectors:i,kernel:s}){this.J=e,this.size=2*e+1,this.energies=t,this.middle=t.reduce((r,o)=>r+o,0)/this.size,this.vectors=ht(i),this.kernel=s}level(e){return{re:Float64Array.from({length:this.size},(t,i)=>this.vectors[i*this.size+e]),im:new Float64Array(this.size)}}coherent([e,t,i]){let{J:s,size:r}=this,[o,a]=[Math.atan2(Math.hypot(e,i),t),Math.atan2(e,i)],[l,c]=[Math.log(Math.cos(.5*o)),Math.log(Math.sin(.5*o))],[u,h]=[new Float64Array(r),new Float64Array(r)],d=0;for(let f=0;f<r;f++){let[p,x]=[2*s-f,s-f],m=.5*d+(p?p*l:0)+(f?f*c:0);u[f]=Math.exp(m)*Math.cos(x*a),h[f]=-Math.exp(m)*Math.sin(x*a),d+=Math.log((2*s-f)/(f+1))}return{re:u,im:h}}parts({re:e,im:t}){let{size:i,vectors:s}=this,[r,o]=[new Float64Array(i),new Float64Array(i)];for(let a=0;a<i;a++)for(let l=0;l<i;l++)r[l]+=s[a*i+l]*e[a],o[l]+=s[a*i+l]*t[a];return{x:r,y:o}}at({x:e,y:t},i){let{size:s,vectors:r}=this,[o,a]=[new Float64Array(s),new Float64Array(s)];for(let l=0;l<s;l++){if(e[l]===0&&t[l]===0)continue;let c=(this.energies[l]-this.middle)*i,u=RC*(c-Math.round(c)),[h,d]=[Math.cos(u),Math.sin(u)],[f,p]=[h*e[l]-d*t[l],d*e[l]+h*t[l]];for(let x=0;x<s;x++)o[x]+=r[x*s+l]*f,a[x]+=r[x*s+l]*p}return{re:o,im:a}}mean({re:e,im:t}){let{J:i,size:s}=this,[r,o,a]=[0,0,0];for(let l=0;l<s;l++){if(o+=(i-l)*(e[l]*e[l]+t[l]*t[l]),l+1===s)continue;let c=Math.sqrt((l+1)*(2*i-l));a+=c*(e[l]*e[l+1]+t[l]*t[l+1]),r+=c*(e[l]*t[l+1]-t[l]*e[l+1])}return[r/i,o/i,a/i]}};function CC(n,e){let[t,i]=[Math.cos(.5*e),Math.sin(.5*e)],s=Float64Array.of(1);for(let r=1;r<=2*n;r++){let o=new Float64Array((r+1)*(r+1));for(let a=0;a<=r;a++)for(let l=0;l<=r;l++){let c=0;a<r&&l<r&&(c+=t*Math.sqrt((r-a)*(r-l))*s[a*r+l]),a<r&&l>0&&(c-=i*Math.sqrt((r-a)*l)*s[a*r+l-1]),a>0&&l<r&&(c+=i*Math.sqrt(a*(r-l))*s[(a-1)*r+l]),a>0&&l>0&&(c+=t*Math.sqrt(a*l)*s[(a-1)*r+l-1]),o[a*(r+1)+l]=c/r}s=o}return s}function IC(n,e,t){let i=2*n+1,s=CC(n,e),r=s.map((l,c)=>l*t[c%i]),o=new Float64Array(i*(i+1)/2),a=0;for(let l=0;l<i;l++)for(let c=0;c+l<i;c++){let u=0;for(let h=0;h<i;h++)u+=r[c*i+h]*s[(c+l)*i+h];o[a++]=u}return o}var Wu=class{constructor(e,t,i){[this.J,this.rows,this.columns]=[e,i,2*i];let s=2*e+1;this.kernels=Array.from({length:i},(o,a)=>IC(e,(a+.5)*Math.PI/i,t));let r=o=>(o+.5)*2*Math.PI/this.columns;this.cosines=Array.from({length:s},(o,a)=>Float64Array.from({length:this.columns},(l,c)=>Math.cos(a*r(c)))),this.sines=Array.from({length:s},(o,a)=>Float64Array.from({length:this.columns},(l,c)=>Math.sin(a*r(c))))}of({re:e,im:t}){let{rows:i,columns:s}=this,r=2*this.J+1,[o,a]=[new Float64Array(r*(r+1)/2),new Float64Array(r*(r+1)/2)],l=0;for(let h=0;h<r;h++)for(let d=0;d+h<r;d++,l++){let f=h?2:1;o[l]=f*(e[d]*e[d+h]+t[d]*t[d+h]),a[l]=f*(e[d]*t[d+h]-t[d]*e[d+h])}let c=new Float32Array(i*s),u=new Float64Array(s);for(let h=0;h<i;h++){let d=this.kernels[h];u.fill(0);let f=0;for(let p=0;p<r;p++){let[x,m]=[0,0];for(let v=0;v+p<r;v++,f++)x+=d[f]*o[f],m+=d[f]*a[f];let[g,y]=[this.cosines[p],this.sines[p]];for(let v=0;v<s;v++)u[v]+=x*g[v]+m*y[v]}c.set(u,h*s)}return c}};var Fx=Math.PI/180,Ui=-1,PC=400,LC=500,[Ox,NC]=[[64,192],6],DC=!0,UC=["state.level","state.lean","state.towards"],FC={state:{level:1,direction:3}};function OC(n){let e=n.vectors?new Hu(n):null;return{...n,spin:e,rotor:{map:null},level:n.level??Ui,first:n.direction}}function BC({spin:n,levels:e,level:t,direction:i}){let s=e.map(({name:l},c)=>[c,l]),r={key:"state.level",label:n?"state":"level",value:t,choices:n?[[Ui,"L as sharp as it can be"],...s]:s};if(t!==Ui)return[r];let{lean:o,towards:a}=Bf(i);return[r,{key:"state.lean",label:"L leans from the b axis by",unit:"\xB0",si:Fx,value:o,low:0,high:Math.PI},{key:"state.towards",label:"towards (0\xB0 is a, 90\xB0 is c)",unit:"\xB0",si:Fx,value:a,low:-Math.PI,high:Math.PI}]}var Bf=([n,e,t])=>({lean:Math.atan2(Math.hypot(n,t),e),towards:n||t?Math.atan2(t,n):0});function kC(n,e,t){if(e==="state.level")return Bx(n,t);let{lean:i,towards:s}={...Bf(n.direction),towards:n.towards??Bf(n.direction).towards,[e.split(".")[1]]:t},r=[Math.sin(i)*Math.cos(s),Math.cos(i),Math.sin(i)*Math.sin(s)];return{...n,direction:r,towards:s,level:Ui}}function Bx(n,e){let t=Number(e);if(t===Ui&&n.spin)return{...n,level:t};if(!Number.isInteger(t)||!n.levels[t])throw new RangeError(`state.level must be a whole number from 0 to ${n.levels.length-1}; got ${e}.`);return{...n,level:t,direction:n.levels[t].start}}function zC(n,e){if(n.level===Ui)return{...n,direction:e,towards:null};let t=o=>o.reduce((a,l,c)=>a+n.constants[c]*l*l,0),i=t(e),s=n.levels.map(({start:o})=>Math.abs(t(o)-i)),r=s.indexOf(Math.min(...s));return{...n,level:r,direction:GC(n.constants,n.levels[r].start,e)}}function GC([n,e,t],i,s){let r=n*i[0]**2+t*i[2]**2,o=r>e,[a,l]=o?[0,2]:[2,0],c=Math.sqrt((o?n-r:r-t)/(o?n-e:e-t)),u=Math.abs(i[l]);if(!(u>0)||!Number.isFinite(c))return i;let h=Math.atan2(s[1]/c,s[l]/u),d=[0,0,0];return[d[l],d[1]]=[u*Math.cos(h),Math.min(1,c)*Math.sin(h)],d[a]=(s[a]<0?-1:1)*Math.sqrt(Math.max(0,1-d[l]**2-d[1]**2)),Wa(d)}var qu=class extends yi{constructor({moments:e,constants:t,momentumSize:i,attitude:s,direction:r,level:o,levels:a,spin:l,rotor:c,J:u}){super({moments:e,momentum:r.map(h=>h*i),attitude:s,epoch:0}),[this.constants,this.spin,this.J,this.rotor]=[t,l,u,c],this.level=o===Ui?null:o,this.ladder=a,this.direction=r,this.parts=this.level===null?l.parts(l.coherent(r)):null,this.wanted=this.level===null?this.flipping():null}flipping(){let[e,t,i]=this.constants,s=4*Math.PI*(this.J+.5)*Math.sqrt((e-t)*(t-i)),r=Number.isFinite(this.period??NaN)?this.period:1/0,o=Math.min(3*r,2*(2*Math.log(this.J)+8)/s);return Number.isFinite(o)?o:null}spinAt(e){return this.parts?this.spin.at(this.parts,e):this.spin.level(this.level)}get map(){let e=Math.min(Ox[1],Math.max(Ox[0],NC*this.J));return this.rotor.map??=new Wu(this.J,this.spin.kernel,e),this.rotor.map}get cloud(){return this.members??=this.parts?Lx(this.constants,this.J,this.direction,PC):[],this.members}plots(e){if(!this.parts)return null;let t=Math.max(1,Math.ceil(e.length/LC)),i=e.filter((c,u)=>u%t===0||u===e.length-1),s=Math.hypot(...this.state(0).momentum),r=i.map(c=>this.spin.mean(this.spinAt(c))),o=i.map(c=>this.state(c).momentum[1]/s),a=i.map(c=>this.meanOfCloud(c)[1]),l=(c,u)=>({name:c,times:i,values:u});return[{title:"L along the b axis, in |L|",unit:"",series:[{...l("quantum \u27E8L\u27E9",r.map(c=>c[1])),role:"motion"},{...l("one classical body",o),role:"classical"},{...l("mean of classical bodies",a),role:"ensemble"}]},{title:"quantum \u27E8L\u27E9 along the axes, in J",unit:"",along:!0,series:["a","b","c"].map((c,u)=>l(c,r.map(h=>h[u])))}]}meanOfCloud(e){let t=[0,0,0];for(let i of this.cloud)i.at(e).forEach((s,r)=>t[r]+=s);return t.map(i=>i/this.cloud.length*((this.J+.5)/this.J))}},VC=n=>new qu(n),HC=({level:n,direction:e})=>({state:n===Ui?{direction:e}:{level:n}});function WC(n,{state:e={}}){if(e.direction){if(!n.spin)throw new RangeError(`state.direction asks for a state of a spin, which the page has up to J = ${n.largestJ}. Set state.level.`);if(!(Math.hypot(...e.direction)>0))throw new RangeError("state.direction must not be zero.");return{...n,level:Ui,direction:Wa(e.direction),towards:null}}return e.level===void 0?n:Bx(n,e.level)}function qC({level:n,levels:e,constants:t,J:i,said:s,direction:r,first:o},a){if(n!==Ui)return e[n].said;let l=(i+.5)**2*r.reduce((h,d,f)=>h+t[f]*d*d,0),c=[["classical energy E/hc",`${et(l/29979245800,7)} cm\u207B\xB9`]],{period:u}=a;return u!==null&&Number.isFinite(u)&&c.push(["classical L goes round its polhode in",En(u,u)]),r===o?[...c,...s]:c}var kx={DampedBody:hf,EulerDisk:ff,FreeMotion:Lf,Gyrostat:Nf,HeavyTop:Df,LagrangeMotion:Ff,QuantumRotor:kf};var zx=.08,XC=8,[$C,YC]=[400,3e3],ZC=24e3,Gx=16*Number.EPSILON,zf=.5,Xu=([n,e,t,i])=>new rt(e,t,i,n),$u=class n{constructor(e,t=null,i=null){this.solver=e,this.moments=e.moments,this.free=e instanceof yi?e.moments:null,this.hasUp=e.mgl!==void 0||!!e.onPlane,this.endless=!0,this.joined=!0,this.times=t?.length?t:this.window(e.epoch),this.count=this.times.length,this.space=i?Xu(i):this.upright(),this.fill(),this.fine=Math.max(1,Math.min(Math.ceil(this.fastest*this.span/(zx*(this.count-1||1))),Math.floor(ZC/this.count)))}window(e){let t=this.solver.mgl?.1*Math.sqrt(Math.abs(this.solver.mgl)/Math.max(...this.moments)):0,i=Math.max(this.speedAt(e),t)||1,s=this.solver.wanted??jC(this.solver,i);s>0&&Number.isFinite(s*i)||Gf();let r=Math.max($C,Math.min(YC,Math.ceil(s*i/zx)+1));return Float64Array.from({length:r},(o,a)=>e+s*a/(r-1))}speedAt(e){return Math.hypot(...this.solved(e).velocity)}upright(){if(this.hasUp)return new rt;let{attitude:e,momentum:t}=this.solver.state(this.solver.epoch),i=new C(...t).applyQuaternion(Xu(e));return i.length()>0?new rt().setFromUnitVectors(i.normalize(),new C(0,0,1)):new rt}fill(){this.attitudes=new Float64Array(4*this.count),this.momenta=new Float64Array(3*this.count),this.velocities=new Float64Array(3*this.count),this.energies=new Float64Array(this.count),this.fastest=0;let e=0;this.dense=null;for(let t=0;t<this.count;t++){let{attitude:i,momentum:s,velocity:r,energy:o}=this.solved(this.times[t]);this.attitudes.set(i,4*t),this.momenta.set(s,3*t),this.velocities.set(r,3*t),this.fastest=Math.max(this.fastest,Math.hypot(...r)),this.energies[t]=o,e=Math.max(e,Math.hypot(...s))}(!Vx(e)||!Vx(this.fastest))&&Gf();for(let t of[this.times,this.attitudes,this.momenta,this.velocities,this.energies])t.every(Number.isFinite)||Gf()}solved(e){let t=this.solver.state(e);if(t.velocity)return t;let i=t.momentum.map((c,u)=>c/this.moments[u]),s=.5*t.momentum.reduce((c,u,h)=>c+u*i[h],0),[r,o,a,l]=t.attitude;return{...t,velocity:i,energy:this.hasUp?s+this.solver.mgl*(r*r-o*o-a*a+l*l):s}}get states(){return this.dense??=Array.from({length:(this.count-1)*this.fine+1},(e,t)=>this.at(t/this.fine)),this.dense}get span(){return this.times[this.count-1]-this.times[0]}attitude(e){return Xu(this.attitudes.subarray(4*e,4*e+4))}at(e){let t=Math.min(Math.floor(e),this.count-1),i=t+1<this.count?e-t:0,s=i?this.times[t]+i*(this.times[t+1]-this.times[t]):this.times[t];return{position:t+i,...this.solvedAt(s)}}solvedAt(e){let{attitude:t,momentum:i,velocity:s,energy:r}=this.solved(e);return{time:e,attitude:Xu(t),momentum:new C(...i),velocity:new C(...s),energy:r}}positionOf(e){let t=this.span>0?(e-this.times[0])/this.span:0;return Math.min(this.count-1,Math.max(0,t*(this.count-1)))}around(e){let[t,i]=[this.times[0],this.times[this.count-1]];if(e>=t&&e<=i)return this;let s=e>i&&e<i+(1-zf)*this.span?i-zf*this.span:e-zf*this.span,r=this.span/(this.count-1);if(!(r>=Gx*Math.max(Math.abs(s),Math.abs(e))))throw new RangeError(`t must be within ${(r/Gx).toPrecision(1)} s, beyond which the points of this picture, ${r.toPrecision(2)} s apart, have hardly times of their own; got ${e}. Give a nearer time.`);let o=this.times.map((h,d)=>s+d*r),{w:a,x:l,y:c,z:u}=this.space;return new n(this.solver,o,[a,l,c,u])}},Vx=n=>n===0||n*n>Number.MIN_VALUE/Number.EPSILON&&Number.isFinite(n*n);function Gf(){throw new RangeError("A number leaves double precision on the way to the picture. Give numbers, in SI units, that are nearer to one.")}function jC(n,e){let t=XC*2*Math.PI/e,i=n.period??n.nutationPeriod??null;return i!==null&&Number.isFinite(i)?Math.max(t,Math.min(2.2*i,12*t)):t}var KC=3,qa=n=>document.getElementById(n),Yu=class{constructor(e,t){this.kind=kx[e.solver],this.given=e,this.changed=t,this.setting=this.first=this.kind.from(e),this.solver=this.kind.make(this.setting);let i={first:qa("controls"),more:qa("more"),fold:qa("folded")};this.controls=new gu(i,(s,r)=>this.move(s,r),s=>this.say(s)),this.show()}motion(e=null,t=null){return new $u(this.solver,e,t)}get event(){return this.kind.event?.(this.setting,this.solver)??null}show(){let e=this.kind.controls(this.setting);this.controls.show(e,this.kind.first??e.slice(0,KC).map(({key:t})=>t)),Zg(qa("facts"),this.kind.facts(this.setting,this.solver))}take(e){let t=[this.solver,this.setting];try{this.solver=this.kind.make(e)}catch(s){return this.refuse(s)}this.say("");let i=String(e.moments)!==String(this.first.moments);this.setting=e;try{this.show(),this.changed(i)}catch(s){return[this.solver,this.setting]=t,this.show(),this.changed(String(this.setting.moments)!==String(this.first.moments)),this.refuse(s)}return!0}refuse(e){let t=e instanceof RangeError,{message:i}=t?e:new RangeError(`The page cannot draw this setting (${e.message}). Take numbers that are nearer to one.`);return this.say(i),!1}move(e,t){if(e===null)return this.show();try{return this.take(this.kind.changed(this.setting,e,t))}catch(i){return this.refuse(i)}}set(e){try{return JC(e,this.kind.keys),this.take(this.kind.withSpec(this.setting,e))}catch(t){return this.refuse(t)}}point(e){this.take(this.kind.withDirection(this.setting,e))}get isAsGiven(){return this.setting===this.first}reset(){this.take(this.first)}say(e){qa("refused").textContent=e}get tables(){return this.isAsGiven?{}:this.kind.asSpec(this.setting)}toml(e){return Wg(()=>this.kind.toml?.(this.setting,e)??null)}};function JC(n,e){if(typeof n!="object"||n===null||Array.isArray(n))throw new RangeError("set takes tables like {spin: {rate: 12}}.");for(let[t,i]of Object.entries(n)){let s=Ih(e,t,"table");if(typeof i!="object"||i===null||Array.isArray(i))throw new RangeError(`${t} must be a table of keys and values, like ${t}.${Object.keys(s)[0]}; got ${Pn(i)}.`);for(let[r,o]of Object.entries(i)){let a=Ih(s,r,"key",`${t}.`),l=[o].flat();if(!(a===0?typeof o=="string":l.length===a&&Array.isArray(o)===a>1)||a&&!l.every(Ch)){let u=a===0?"a word":a===1?`a number, ${sl}`:`${a} numbers in a list, each ${sl}`;throw new RangeError(`${t}.${r} must be ${u}; got ${Pn(o)}. Check the number, which is in SI units.`)}}}}var Hx={languages:["de","es","fr"],table:{Language:["Sprache","Idioma","Langue"],"polhode: a playground":["polhode: ein Spielplatz","polhode: un campo de pruebas","polhode\xA0: un terrain de jeu"],"Motions to play with":["Bewegungen zum Ausprobieren","Movimientos para probar","Mouvements \xE0 essayer"],"Light or dark":["Hell oder dunkel","Claro u oscuro","Clair ou sombre"],"What to watch":["Was es zu sehen gibt","Qu\xE9 observar","Ce qu'il faut observer"],"What you can set":["Was sich einstellen l\xE4sst","Lo que se puede ajustar","Ce que l'on peut r\xE9gler"],"More to set":["Mehr einstellen","M\xE1s ajustes","Plus de r\xE9glages"],"Back to the start":["Zur\xFCck zum Anfang","Volver al inicio","Revenir au d\xE9part"],"Share and save":["Teilen und speichern","Compartir y guardar","Partager et enregistrer"],"Copy link":["Link kopieren","Copiar enlace","Copier le lien"],"Copy embed code":["Einbettungscode kopieren","Copiar c\xF3digo para insertar","Copier le code d'int\xE9gration"],"Copy spec":["Spezifikation kopieren","Copiar especificaci\xF3n","Copier la sp\xE9cification"],"Save picture":["Bild speichern","Guardar imagen","Enregistrer l'image"],"Save film":["Film speichern","Guardar pel\xEDcula","Enregistrer un film"],Stop:["Anhalten","Detener","Arr\xEAter"],of:["von","de","de"],"Length of the film [s]":["L\xE4nge des Films [s]","Duraci\xF3n de la pel\xEDcula [s]","Dur\xE9e du film [s]"],"The text to copy":["Der Text zum Kopieren","El texto que se copia","Le texte \xE0 copier"],"The large picture as it is now":["Das gro\xDFe Bild, wie es jetzt ist","La imagen grande tal como est\xE1 ahora","La grande image telle qu'elle est maintenant"],"Values at this time":["Werte zu dieser Zeit","Valores en este instante","Valeurs \xE0 cet instant"],"Over time":["Zeitverlauf","Evoluci\xF3n temporal","Au cours du temps"],"Made by polhode. Space: play or pause. Arrow keys: step. Home, End: ends. L: loop. + and \u2212: speed. Drag the large picture, or give it the focus and use arrow keys, to turn all views. Two fingers, or Ctrl and the wheel: closer; a click lets the wheel alone do it, until Escape or a click elsewhere.":["Erzeugt von polhode. Leertaste: abspielen oder anhalten. Pfeiltasten: ein Schritt. Pos1, Ende: Anfang und Ende. L: Schleife. + und \u2212: Tempo. Das gro\xDFe Bild ziehen, oder es fokussieren und Pfeiltasten dr\xFCcken, dreht alle Ansichten. Zwei Finger, oder Strg und Mausrad: n\xE4her heran; nach einem Klick gen\xFCgt das Mausrad, bis Escape oder ein Klick daneben folgt.","Hecho por polhode. Espacio: reproducir o pausar. Flechas: un paso. Inicio, Fin: los extremos. L: bucle. + y \u2212: velocidad. Arrastrar la imagen grande, o darle el foco y usar las flechas, gira todas las vistas. Dos dedos, o Ctrl y la rueda: m\xE1s cerca; tras un clic basta la rueda, hasta Escape o un clic fuera.","Produit par polhode. Espace\xA0: lecture ou pause. Fl\xE8ches\xA0: un pas. D\xE9but, Fin\xA0: les extr\xE9mit\xE9s. L\xA0: boucle. + et \u2212\xA0: vitesse. Faire glisser la grande image, ou lui donner le focus et utiliser les fl\xE8ches, tourne toutes les vues. Deux doigts, ou Ctrl et la molette\xA0: plus pr\xE8s\xA0; apr\xE8s un clic la molette seule suffit, jusqu'\xE0 \xC9chap ou un clic ailleurs."],Time:["Zeit","Tiempo","Temps"],"One step back":["Ein Schritt zur\xFCck","Un paso atr\xE1s","Un pas en arri\xE8re"],"One step back (\u2190)":["Ein Schritt zur\xFCck (\u2190)","Un paso atr\xE1s (\u2190)","Un pas en arri\xE8re (\u2190)"],"One step forward":["Ein Schritt vor","Un paso adelante","Un pas en avant"],"One step forward (\u2192)":["Ein Schritt vor (\u2192)","Un paso adelante (\u2192)","Un pas en avant (\u2192)"],Play:["Abspielen","Reproducir","Lecture"],Pause:["Anhalten","Pausa","Pause"],"Play or pause (space)":["Abspielen oder anhalten (Leertaste)","Reproducir o pausar (espacio)","Lecture ou pause (espace)"],Loop:["Schleife","Bucle","Boucle"],"Loop (l)":["Schleife (l)","Bucle (l)","Boucle (l)"],Slower:["Langsamer","M\xE1s lento","Plus lent"],"Slower (\u2212)":["Langsamer (\u2212)","M\xE1s lento (\u2212)","Plus lent (\u2212)"],Faster:["Schneller","M\xE1s r\xE1pido","Plus vite"],"Faster (+)":["Schneller (+)","M\xE1s r\xE1pido (+)","Plus vite (+)"],Speed:["Tempo","Velocidad","Vitesse"],"real time":["Echtzeit","tiempo real","temps r\xE9el"],yr:["a","a","an"],d:["d","d","j"],rpm:["U/min","rpm","tr/min"],"{number} rpm":["{number} U/min","{number} rpm","{number} tr/min"],"{least} to {most}":["{least} bis {most}","de {least} a {most}","de {least} \xE0 {most}"],"The wheel zooms. Esc lets go.":["Das Mausrad zoomt. Esc l\xE4sst los.","La rueda ampl\xEDa. Esc suelta.","La molette zoome. \xC9chap rel\xE2che."],"Make large: {picture}":["Vergr\xF6\xDFern: {picture}","Agrandar: {picture}","Agrandir\xA0: {picture}"],"Arrow keys turn the view, page up and down bring it closer.":["Pfeiltasten drehen die Ansicht, Bild auf und Bild ab zoomen.","Las flechas giran la vista, ReP\xE1g y AvP\xE1g la acercan o alejan.","Les fl\xE8ches tournent la vue, page pr\xE9c\xE9dente et page suivante zooment."],"show {part}":["{part} zeigen","mostrar: {part}","montrer\xA0: {part}"],"Set on this page.":["Auf dieser Seite eingestellt.","Ajustado en esta p\xE1gina.","R\xE9gl\xE9 sur cette page."],"Show it":["Zeigen","Mostrarlo","Le montrer"],"The playground has no motion called {named}; it has {keys}.":["Der Spielplatz hat keine Bewegung namens {named}; er hat {keys}.","El campo de pruebas no tiene ning\xFAn movimiento llamado {named}; tiene {keys}.","Le terrain de jeu n'a pas de mouvement nomm\xE9 {named}\xA0; il a {keys}."],"The pictures cannot be drawn ({why}). They need a browser with WebGL 2.":["Die Bilder lassen sich nicht zeichnen ({why}). Sie brauchen einen Browser mit WebGL 2.","No se pueden dibujar las im\xE1genes ({why}). Necesitan un navegador con WebGL 2.","Les images ne peuvent pas \xEAtre dessin\xE9es ({why}). Il leur faut un navigateur avec WebGL 2."],"A number is needed.":["Hier muss eine Zahl stehen.","Hace falta un n\xFAmero.","Il faut un nombre."],"It must be greater than zero.":["Sie muss gr\xF6\xDFer als null sein.","Debe ser mayor que cero.","Il doit \xEAtre sup\xE9rieur \xE0 z\xE9ro."],"No body has this moment with the two others: {least} to {most} {unit}.":["Kein K\xF6rper hat dieses Tr\xE4gheitsmoment zusammen mit den beiden anderen: {least} bis {most} {unit}.","Ning\xFAn cuerpo tiene este momento de inercia con los otros dos: de {least} a {most} {unit}.","Aucun corps n'a ce moment d'inertie avec les deux autres\xA0: de {least} \xE0 {most} {unit}."],"This browser keeps the clipboard from pages in frames: copy the text from the field below.":["Dieser Browser verwehrt Seiten in Rahmen die Zwischenablage: Bitte den Text aus dem Feld unten kopieren.","Este navegador niega el portapapeles a las p\xE1ginas en marcos: copie el texto del campo de abajo.","Ce navigateur refuse le presse-papiers aux pages dans un cadre\xA0: copiez le texte du champ ci-dessous."],"A page in a notebook has no address of its own. Write it to a file with write_page, and add this to the file's address.":["Eine Seite in einem Notebook hat keine eigene Adresse. Schreiben Sie sie mit write_page in eine Datei und h\xE4ngen Sie dies an deren Adresse an.","Una p\xE1gina en un cuaderno no tiene direcci\xF3n propia. Escr\xEDbala en un archivo con write_page y a\xF1ada esto a la direcci\xF3n del archivo.","Une page dans un notebook n'a pas d'adresse propre. \xC9crivez-la dans un fichier avec write_page, et ajoutez ceci \xE0 l'adresse du fichier."],"The link is copied.":["Der Link ist kopiert.","El enlace est\xE1 copiado.","Le lien est copi\xE9."],"The link is copied. It opens on this computer only: put the file on a web server to give it to others.":["Der Link ist kopiert. Er \xF6ffnet sich nur auf diesem Rechner: Legen Sie die Datei auf einen Webserver, um ihn weiterzugeben.","El enlace est\xE1 copiado. Solo se abre en este ordenador: ponga el archivo en un servidor web para darlo a otros.","Le lien est copi\xE9. Il ne s'ouvre que sur cet ordinateur\xA0: placez le fichier sur un serveur web pour le donner \xE0 d'autres."],"A page in a notebook has no address that another page could embed. Write it to a file with write_page, and put the file on a web server.":["Eine Seite in einem Notebook hat keine Adresse, die eine andere Seite einbetten k\xF6nnte. Schreiben Sie sie mit write_page in eine Datei, und legen Sie diese auf einen Webserver.","Una p\xE1gina en un cuaderno no tiene una direcci\xF3n que otra p\xE1gina pueda insertar. Escr\xEDbala en un archivo con write_page y ponga el archivo en un servidor web.","Une page dans un notebook n'a pas d'adresse qu'une autre page pourrait int\xE9grer. \xC9crivez-la dans un fichier avec write_page, et placez-le sur un serveur web."],"The code is copied: paste it into the HTML of a page.":["Der Code ist kopiert: F\xFCgen Sie ihn in das HTML einer Seite ein.","El c\xF3digo est\xE1 copiado: p\xE9guelo en el HTML de una p\xE1gina.","Le code est copi\xE9\xA0: collez-le dans le HTML d'une page."],"No spec says this start. A gyrostat needs its rotor's moment, and a free rotor a principal axis; a disk must begin in steady rolling.":["Keine Spezifikation beschreibt diesen Anfang. Ein Gyrostat braucht das Tr\xE4gheitsmoment seines Rotors, und ein freier Rotor eine Hauptachse; eine Scheibe muss mit station\xE4rem Rollen beginnen.","Ninguna especificaci\xF3n describe este inicio. Un girostato necesita el momento de inercia de su rotor, y un rotor libre un eje principal; un disco debe empezar rodando de forma estacionaria.","Aucune sp\xE9cification ne d\xE9crit ce d\xE9part. Un gyrostat demande le moment d'inertie de son rotor, et un rotor libre un axe principal\xA0; un disque doit commencer par un roulement stationnaire."],"The spec is copied: paste it into a file, and run polhode report on it.":["Die Spezifikation ist kopiert: F\xFCgen Sie sie in eine Datei ein, und f\xFChren Sie polhode report damit aus.","La especificaci\xF3n est\xE1 copiada: p\xE9guela en un archivo y ejecute polhode report con \xE9l.","La sp\xE9cification est copi\xE9e\xA0: collez-la dans un fichier, et lancez polhode report dessus."],"A frame like this one may not save files: save the picture below by a right click, or by a long press.":["Ein Rahmen wie dieser darf keine Dateien speichern: Sichern Sie das Bild unten durch einen Rechtsklick oder langes Dr\xFCcken.","Un marco como este no puede guardar archivos: guarde la imagen de abajo con un clic derecho o una pulsaci\xF3n larga.","Un cadre comme celui-ci ne peut pas enregistrer de fichiers\xA0: enregistrez l'image ci-dessous par un clic droit ou un appui long."],"The picture is saved.":["Das Bild ist gespeichert.","La imagen est\xE1 guardada.","L'image est enregistr\xE9e."],"This browser cannot record films: it has no MediaRecorder for canvases. Firefox and Chromium have.":["Dieser Browser kann keine Filme aufnehmen: Er hat keinen MediaRecorder f\xFCr Zeichenfl\xE4chen. Firefox und Chromium haben ihn.","Este navegador no puede grabar pel\xEDculas: no tiene MediaRecorder para lienzos. Firefox y Chromium lo tienen.","Ce navigateur ne peut pas enregistrer de films\xA0: il n'a pas de MediaRecorder pour les canevas. Firefox et Chromium en ont un."],"Recording: {passed} of {seconds} s.":["Aufnahme: {passed} von {seconds} s.","Grabando: {passed} de {seconds} s.","Enregistrement\xA0: {passed} sur {seconds} s."],"The browser has recorded nothing.":["Der Browser hat nichts aufgenommen.","El navegador no ha grabado nada.","Le navigateur n'a rien enregistr\xE9."],"The film is recorded. If it was not saved, this frame may not save files: open the page on its own.":["Der Film ist aufgenommen. Wurde er nicht gespeichert, darf dieser Rahmen keine Dateien speichern: \xD6ffnen Sie die Seite f\xFCr sich.","La pel\xEDcula est\xE1 grabada. Si no se ha guardado, este marco no puede guardar archivos: abra la p\xE1gina por s\xED sola.","Le film est enregistr\xE9. S'il n'a pas \xE9t\xE9 sauvegard\xE9, ce cadre ne peut pas \xE9crire de fichiers\xA0: ouvrez la page seule."],"The film is saved.":["Der Film ist gespeichert.","La pel\xEDcula est\xE1 guardada.","Le film est enregistr\xE9."],nothing:["nichts","nada","rien"],"A film takes {least} to {most} s; got {got}. Type a number between these.":["Ein Film dauert {least} bis {most} s; eingegeben ist {got}. Geben Sie eine Zahl dazwischen ein.","Una pel\xEDcula dura de {least} a {most} s; se ha dado {got}. Escriba un n\xFAmero entre ambos.","Un film dure de {least} \xE0 {most} s\xA0; re\xE7u\xA0: {got}. Tapez un nombre entre ces deux valeurs."],"The body in space":["Der K\xF6rper im Raum","El cuerpo en el espacio","Le corps dans l'espace"],"L points up":["L zeigt nach oben","L apunta hacia arriba","L pointe vers le haut"],"box or ellipsoid of the same inertia":["Quader oder Ellipsoid gleicher Tr\xE4gheit","paralelep\xEDpedo o elipsoide de la misma inercia","pav\xE9 ou ellipso\xEFde de m\xEAme inertie"],"box of the same inertia":["Quader gleicher Tr\xE4gheit","paralelep\xEDpedo de la misma inercia","pav\xE9 de m\xEAme inertie"],"ellipsoid of the same inertia":["Ellipsoid gleicher Tr\xE4gheit","elipsoide de la misma inercia","ellipso\xEFde de m\xEAme inertie"],"inertia ellipsoid, as no solid body has these moments":["Tr\xE4gheitsellipsoid, da kein K\xF6rper diese Momente hat","elipsoide de inercia: ning\xFAn s\xF3lido tiene estos momentos","ellipso\xEFde d'inertie, car aucun solide n'a ces moments"],"axes only, as nothing is known of the body's shape":["nur die Achsen, da die Gestalt des K\xF6rpers unbekannt ist","solo los ejes, pues no se conoce la forma del cuerpo","les axes seuls, car la forme du corps est inconnue"],"its mesh, coarsened":["sein Netz, vergr\xF6bert","su malla, simplificada","son maillage, simplifi\xE9"],"disk on a stem, of the same inertia about the pivot":["Scheibe auf einem Stiel, mit gleicher Tr\xE4gheit um den St\xFCtzpunkt","disco sobre un v\xE1stago, con la misma inercia respecto al pivote","disque sur une tige, de m\xEAme inertie autour du pivot"],"trace of axis {axis}":["Spur der Achse {axis}","traza del eje {axis}","trace de l'axe {axis}"],"trace of the axis through the centre of mass":["Spur der Achse durch den Schwerpunkt","traza del eje por el centro de masas","trace de l'axe passant par le centre de masse"],"weight mg":["Gewicht mg","peso mg","poids mg"],"torque of the weight, dL/dt":["Drehmoment des Gewichts, dL/dt","momento del peso, dL/dt","moment du poids, dL/dt"],"cone of \u03A9 in space":["Kegel von \u03A9 im Raum","cono de \u03A9 en el espacio","c\xF4ne de \u03A9 dans l'espace"],"cone of \u03A9 about L (space cone)":["Kegel von \u03A9 um L (Rastpolkegel)","cono de \u03A9 en torno a L (cono espacial)","c\xF4ne de \u03A9 autour de L (c\xF4ne de base)"],"cone of \u03A9 in the body":["Kegel von \u03A9 im K\xF6rper (Gangpolkegel)","cono de \u03A9 en el cuerpo (cono del cuerpo)","c\xF4ne de \u03A9 dans le corps (c\xF4ne roulant)"],"cone of the axis":["Kegel der Achse","cono del eje","c\xF4ne de l'axe"],"rotor, drawn at rest: its moment is not given":["Rotor, ruhend gezeichnet: sein Tr\xE4gheitsmoment ist nicht angegeben","rotor, dibujado en reposo: no se da su momento","rotor, dessin\xE9 au repos\xA0: son moment n'est pas donn\xE9"],"rotor, {rate} against the body":["Rotor, {rate} gegen den K\xF6rper","rotor, {rate} respecto al cuerpo","rotor, {rate} par rapport au corps"],"Path of the axis":["Bahn der Achse","Trayectoria del eje","Trajectoire de l'axe"],"from the pivot towards the centre of mass":["vom St\xFCtzpunkt zum Schwerpunkt","del pivote hacia el centro de masas","du pivot vers le centre de masse"],"third principal axis":["dritte Hauptachse","tercer eje principal","troisi\xE8me axe principal"],axis:["Achse","eje","axe"],"limits of its tilt":["Grenzen ihrer Neigung","l\xEDmites de su inclinaci\xF3n","limites de son inclinaison"],up:["oben","arriba","haut"],"Poinsot's ellipsoid":["Poinsot-Ellipsoid","Elipsoide de Poinsot","Ellipso\xEFde de Poinsot"],"rolls without slipping on the plane across L":["rollt ohne Gleiten auf der Ebene senkrecht zu L","rueda sin deslizar sobre el plano perpendicular a L","roule sans glisser sur le plan perpendiculaire \xE0 L"],"at rest":["in Ruhe","en reposo","au repos"],polhode:["Polhodie","polhodia","polhodie"],herpolhode:["Herpolhodie","herpolhodia","herpolhodie"],"contact, \u2212\u03A9":["Ber\xFChrpunkt, \u2212\u03A9","contacto, \u2212\u03A9","contact, \u2212\u03A9"],"Momentum sphere":["Drehimpulskugel","Esfera del momento angular","Sph\xE8re du moment cin\xE9tique"],"L in body axes runs along its polhode":["L l\xE4uft in k\xF6rperfesten Achsen entlang seiner Polhodie","L, en los ejes del cuerpo, recorre su polhodia","L, dans les axes du corps, parcourt sa polhodie"],"L in body axes runs along its polhode; dots are the log's samples":["L l\xE4uft in k\xF6rperfesten Achsen entlang seiner Polhodie; Punkte sind die Messwerte","L, en los ejes del cuerpo, recorre su polhodia; los puntos son las medidas","L, dans les axes du corps, parcourt sa polhodie\xA0; les points sont les mesures"],"direction of L in body axes":["Richtung von L in k\xF6rperfesten Achsen","direcci\xF3n de L en los ejes del cuerpo","direction de L dans les axes du corps"],"direction of L in body axes; levels are those at the end":["Richtung von L in k\xF6rperfesten Achsen; Niveaulinien f\xFCr das Ende","direcci\xF3n de L en los ejes del cuerpo; los niveles son los del final","direction de L dans les axes du corps\xA0; niveaux \xE0 la fin"],"other polhodes":["andere Polhodien","otras polhodias","autres polhodies"],"levels of energy":["Niveaulinien der Energie","niveles de energ\xEDa","niveaux d'\xE9nergie"],"this motion":["diese Bewegung","este movimiento","ce mouvement"],measured:["gemessen","medido","mesur\xE9"],separatrix:["Separatrix","separatriz","s\xE9paratrice"],stable:["stabil","estable","stable"],unstable:["instabil","inestable","instable"],undecided:["unentschieden","indeciso","ind\xE9cis"],"ellipsoid of the same energy":["Ellipsoid gleicher Energie","elipsoide de la misma energ\xEDa","ellipso\xEFde de m\xEAme \xE9nergie"],"Levels of J = {J} as polhodes":["Niveaus von J = {J} als Polhodien","Niveles de J = {J} como polhodias","Niveaux de J = {J} en polhodies"],"drag the point to another level, or L":["den Punkt auf ein anderes Niveau ziehen, oder L","arrastre el punto a otro nivel, o L","faites glisser le point vers un autre niveau, ou L"],"levels round {axis}":["Niveaus um {axis}","niveles en torno a {axis}","niveaux autour de {axis}"],"Wigner function":["Wigner-Funktion","Funci\xF3n de Wigner","Fonction de Wigner"],"of the quantum state, and classical bodies that began as it did":["des Quantenzustands, mit klassischen K\xF6rpern, die wie er begannen","del estado cu\xE1ntico, con cuerpos cl\xE1sicos que empezaron igual","de l'\xE9tat quantique, et corps classiques partis comme lui"],"of the level {level}, and its polhodes":["des Niveaus {level}, mit seinen Polhodien","del nivel {level}, y sus polhodias","du niveau {level}, et ses polhodies"],negative:["negativ","negativo","n\xE9gatif"],positive:["positiv","positivo","positif"],"classical L":["klassisches L","L cl\xE1sico","L classique"],"The rolling disk":["Die rollende Scheibe","El disco rodante","Le disque roulant"],"with the path of its contact":["mit der Bahn ihres Ber\xFChrpunkts","con la trayectoria de su contacto","avec la trajectoire de son contact"],contact:["Ber\xFChrpunkt","contacto","contact"],"below the centre":["unter dem Mittelpunkt","bajo el centro","sous le centre"],"sound of the contact":["Klang des Ber\xFChrpunkts","sonido del contacto","son du contact"],"Point vortices":["Punktwirbel","V\xF3rtices puntuales","Tourbillons ponctuels"],"in the plane, from above":["in der Ebene, von oben","en el plano, desde arriba","dans le plan, vu de dessus"],"on the sphere":["auf der Kugel","sobre la esfera","sur la sph\xE8re"],anticlockwise:["gegen den Uhrzeigersinn","antihorario","sens antihoraire"],clockwise:["im Uhrzeigersinn","horario","sens horaire"],Vorticity:["Wirbelst\xE4rke","Vorticidad","Vorticit\xE9"],"of the fluid against the sphere":["des Fluids gegen die Kugel","del fluido respecto a la esfera","du fluide par rapport \xE0 la sph\xE8re"],"against the sphere, with lines of the field":["gegen die Kugel, mit Feldlinien","respecto a la esfera, con l\xEDneas de campo","par rapport \xE0 la sph\xE8re, avec les lignes de champ"],Current:["Strom","Corriente","Courant"],"through the sphere, with lines of the field":["durch die Kugel, mit Feldlinien","a trav\xE9s de la esfera, con l\xEDneas de campo","\xE0 travers la sph\xE8re, avec les lignes de champ"],inward:["einw\xE4rts","entrante","entrant"],outward:["ausw\xE4rts","saliente","sortant"],Spins:["Spins","Espines","Spins"],"from above, red towards the reader":["von oben, rot zum Betrachter hin","desde arriba, rojo hacia el lector","vu de dessus, rouge vers le lecteur"],"towards the reader":["zum Betrachter hin","hacia el lector","vers le lecteur"],away:["vom Betrachter weg","alej\xE1ndose","en s'\xE9loignant"],"Spin on the orbit":["Drehung auf der Bahn","Giro en la \xF3rbita","Rotation sur l'orbite"],"seen from above; the moon is drawn large":["von oben gesehen; der Mond ist vergr\xF6\xDFert","vista desde arriba; la luna est\xE1 ampliada","vu de dessus\xA0; la lune est agrandie"],"long axis":["lange Achse","eje largo","grand axe"],planet:["Planet","planeta","plan\xE8te"],"Phase space":["Phasenraum","Espacio de fases","Espace des phases"],"position to the right, velocity upwards":["Ort nach rechts, Geschwindigkeit nach oben","posici\xF3n a la derecha, velocidad hacia arriba","position vers la droite, vitesse vers le haut"],"many electrons":["viele Elektronen","muchos electrones","beaucoup d'\xE9lectrons"],few:["wenige","pocos","peu"],"\u03A9 along the body's axes":["\u03A9 entlang der K\xF6rperachsen","\u03A9 seg\xFAn los ejes del cuerpo","\u03A9 selon les axes du corps"],"L along the body's axes":["L entlang der K\xF6rperachsen","L seg\xFAn los ejes del cuerpo","L selon les axes du corps"],"angles of the axes from L":["Winkel der Achsen gegen L","\xE1ngulos de los ejes con L","angles des axes avec L"],"tilt of the axis from the vertical":["Neigung der Achse gegen die Senkrechte","inclinaci\xF3n del eje respecto a la vertical","inclinaison de l'axe par rapport \xE0 la verticale"],tilt:["Neigung","inclinaci\xF3n","inclinaison"],"axis 1":["Achse 1","eje 1","axe 1"],"axis 2":["Achse 2","eje 2","axe 2"],"axis 3":["Achse 3","eje 3","axe 3"],"axis {axis}":["Achse {axis}","eje {axis}","axe {axis}"],"the polhode from above, {across} across: the sphere magnified {times} times":["die Polhodie von oben, {across} breit: die Kugel {times}-fach vergr\xF6\xDFert","la polhodia desde arriba, {across} de ancho: la esfera ampliada {times} veces","la polhodie vue de dessus, large de {across}\xA0: la sph\xE8re grossie {times} fois"],"with the point that moves":["mit dem bewegten Punkt","con el punto que se mueve","avec le point mobile"],"over time":["im Zeitverlauf","a lo largo del tiempo","au cours du temps"],"L along the b axis, in |L|":["L entlang der b-Achse, in |L|","L seg\xFAn el eje b, en |L|","L selon l'axe b, en |L|"],"quantum \u27E8L\u27E9":["quantenmechanisches \u27E8L\u27E9","\u27E8L\u27E9 cu\xE1ntico","\u27E8L\u27E9 quantique"],"one classical body":["ein klassischer K\xF6rper","un cuerpo cl\xE1sico","un corps classique"],"mean of classical bodies":["Mittel klassischer K\xF6rper","media de cuerpos cl\xE1sicos","moyenne de corps classiques"],"quantum \u27E8L\u27E9 along the axes, in J":["quantenmechanisches \u27E8L\u27E9 entlang der Achsen, in J","\u27E8L\u27E9 cu\xE1ntico seg\xFAn los ejes, en J","\u27E8L\u27E9 quantique selon les axes, en J"],Tilt:["Neigung","Inclinaci\xF3n","Inclinaison"],Precession:["Pr\xE4zession","Precesi\xF3n","Pr\xE9cession"],"the whole motion: log\u2081\u2080 {unit} against log\u2081\u2080 of the time left [s], which runs to the left":["die ganze Bewegung: log\u2081\u2080 {unit} gegen log\u2081\u2080 der verbleibenden Zeit [s], die nach links l\xE4uft","todo el movimiento: log\u2081\u2080 {unit} frente a log\u2081\u2080 del tiempo restante [s], que va hacia la izquierda","tout le mouvement\xA0: log\u2081\u2080 {unit} en fonction du log\u2081\u2080 du temps restant [s], qui va vers la gauche"],"energy in eddies":["Energie in Wirbeln","energ\xEDa en remolinos","\xE9nergie dans les tourbillons"],"of all":["vom Ganzen","del total","du total"],"up to degree {degree}":["bis zum Grad {degree}","hasta el grado {degree}","jusqu'au degr\xE9 {degree}"],energy:["Energie","energ\xEDa","\xE9nergie"],kinetic:["kinetisch","cin\xE9tica","cin\xE9tique"],magnetic:["magnetisch","magn\xE9tica","magn\xE9tique"],magnetisation:["Magnetisierung","magnetizaci\xF3n","aimantation"],"of the largest":["der gr\xF6\xDFten","de la mayor","de la plus grande"],field:["Feld","campo","champ"],"wave {number}":["Welle {number}","onda {number}","onde {number}"],latitude:["Breite","latitud","latitude"],longitude:["L\xE4nge","longitud","longitude"],"angle of the long axis, half turns taken off":["Winkel der langen Achse, ohne halbe Umdrehungen","\xE1ngulo del eje largo, sin medias vueltas","angle du grand axe, demi-tours retir\xE9s"],angle:["Winkel","\xE1ngulo","angle"],rate:["Drehrate","velocidad angular","vitesse angulaire"],"turns per orbit":["Umdrehungen je Umlauf","vueltas por \xF3rbita","tours par orbite"],"distance to a twin that starts 10\u207B\u2076 rad apart":["Abstand von einem Zwilling, der 10\u207B\u2076 rad daneben beginnt","distancia a un gemelo que empieza a 10\u207B\u2076 rad","distance \xE0 un jumeau parti \xE0 10\u207B\u2076 rad"],distance:["Abstand","distancia","distance"],"Section at periapsis":["Schnitt im Perizentrum","Secci\xF3n en el periapsis","Section au p\xE9riastre"],"{count} orbits: \u03B8\u0307/n against \u03B8 [\xB0]":["{count} Uml\xE4ufe: \u03B8\u0307/n gegen \u03B8 [\xB0]","{count} \xF3rbitas: \u03B8\u0307/n frente a \u03B8 [\xB0]","{count} orbites\xA0: \u03B8\u0307/n en fonction de \u03B8 [\xB0]"],"largest drift":["gr\xF6\xDFte Drift","mayor deriva","plus grande d\xE9rive"],"L in space":["L im Raum","L en el espacio","L dans l'espace"],"vertical momentum":["Drehimpuls um die Senkrechte","momento angular vertical","moment cin\xE9tique vertical"],"axial momentum":["Drehimpuls um die Achse","momento angular axial","moment cin\xE9tique axial"],"what it does":["was er tut","qu\xE9 hace","ce qu'il fait"],"keeps |L|":["beh\xE4lt |L|","conserva |L|","conserve |L|"],"loses energy and ends spinning about its axis of largest moment":["verliert Energie und dreht am Ende um die Achse des gr\xF6\xDFten Tr\xE4gheitsmoments","pierde energ\xEDa y acaba girando en torno al eje de mayor momento de inercia","perd de l'\xE9nergie et finit par tourner autour de l'axe de plus grand moment d'inertie"],"losses inside, \u03B1":["innere Verluste, \u03B1","p\xE9rdidas internas, \u03B1","pertes internes, \u03B1"],"energy it can lose inside":["Energie, die er innen verlieren kann","energ\xEDa que puede perder internamente","\xE9nergie qu'il peut perdre en interne"],"within 5\xB0 of the flat spin after":["bis auf 5\xB0 im flachen Drehen nach","a menos de 5\xB0 del giro plano tras","\xE0 moins de 5\xB0 de la rotation \xE0 plat apr\xE8s"],"set the body by":["K\xF6rper einstellen durch","definir el cuerpo por","d\xE9finir le corps par"],"its moments":["seine Tr\xE4gheitsmomente","sus momentos de inercia","ses moments d'inertie"],"the edges of a box":["die Kanten eines Quaders","las aristas de un paralelep\xEDpedo","les ar\xEAtes d'un pav\xE9"],"mass of the box":["Masse des Quaders","masa del paralelep\xEDpedo","masse du pav\xE9"],"edge along axis {axis}":["Kante entlang Achse {axis}","arista seg\xFAn el eje {axis}","ar\xEAte selon l'axe {axis}"],"moment of inertia I{axis}":["Tr\xE4gheits\xADmoment I{axis}","momento de inercia I{axis}","moment d'inertie I{axis}"],"spin rate |\u03A9|":["Drehrate |\u03A9|","velocidad de giro |\u03A9|","vitesse de rotation |\u03A9|"],"tilt counted from":["Neigung gez\xE4hlt von","inclinaci\xF3n contada desde","inclinaison compt\xE9e depuis"],"tilt of the spin":["Neigung der Drehung","inclinaci\xF3n del giro","inclinaison de la rotation"],"tilted towards (0\xB0 is axis {axis})":["geneigt zu (0\xB0 ist Achse {axis})","inclinado hacia (0\xB0 es el eje {axis})","inclin\xE9e vers (0\xB0\xA0: axe {axis})"],"period of L in the body":["Periode von L im K\xF6rper","per\xEDodo de L en el cuerpo","p\xE9riode de L dans le corps"],"precession about L":["Pr\xE4zession um L","precesi\xF3n en torno a L","pr\xE9cession autour de L"],"{angle} per period":["{angle} je Periode","{angle} por per\xEDodo","{angle} par p\xE9riode"],"turns over every":["kippt um alle","se da la vuelta cada","se retourne toutes les"],"turns over and over":["kippt immer wieder um","se da la vuelta una y otra vez","se retourne encore et encore"],"runs up to the intermediate axis and stays there":["l\xE4uft auf die mittlere Hauptachse zu und bleibt dort","llega al eje intermedio y se queda ah\xED","rejoint l'axe interm\xE9diaire et y reste"],"spins steadily":["dreht sich gleichf\xF6rmig","gira uniformemente","tourne uniform\xE9ment"],"cones, its axis {angle} from L":["Kegelbewegung, seine Achse {angle} von L","describe un cono, con el eje a {angle} de L","d\xE9crit un c\xF4ne, son axe \xE0 {angle} de L"],"tumbles, its axis {angle} from L":["taumelt, seine Achse {angle} von L","da tumbos, con el eje a {angle} de L","culbute, son axe \xE0 {angle} de L"],regime:["Bewegungsart","r\xE9gimen","r\xE9gime"],rest:["Ruhe","reposo","repos"],spherical:["kugelsymmetrisch","esf\xE9rico","sph\xE9rique"],permanent:["permanente Drehung","permanente","permanent"],symmetric:["symmetrischer Kreisel","sim\xE9trico","sym\xE9trique"],"short-axis":["um die kurze Achse","eje corto","petit axe"],"long-axis":["um die lange Achse","eje largo","grand axe"],"momentum of the rotor":["Drehimpuls des Rotors","momento angular del rotor","moment cin\xE9tique du rotor"],"rotor speed against the body":["Drehzahl des Rotors gegen den K\xF6rper","velocidad del rotor respecto al cuerpo","vitesse du rotor par rapport au corps"],"rotor's axis leans from L":["Neigung der Rotorachse gegen L","inclinaci\xF3n del eje del rotor sobre L","inclinaison de l'axe du rotor sur L"],"precession of the rotor's axis about L":["Pr\xE4zession der Rotorachse um L","precesi\xF3n del eje del rotor en torno a L","pr\xE9cession de l'axe du rotor autour de L"],"a spin about the rotor's axis":["eine Drehung um die Rotorachse","un giro en torno al eje del rotor","une rotation autour de l'axe du rotor"],"stable, also with losses in the body: least energy":["stabil, auch mit Verlusten im K\xF6rper: kleinste Energie","estable, tambi\xE9n con p\xE9rdidas en el cuerpo: energ\xEDa m\xEDnima","stable, m\xEAme avec des pertes dans le corps\xA0: \xE9nergie minimale"],"stable until losses act: most energy":["stabil, solange nichts verloren geht: gr\xF6\xDFte Energie","estable mientras no haya p\xE9rdidas: energ\xEDa m\xE1xima","stable tant qu'il n'y a pas de pertes\xA0: \xE9nergie maximale"],"unstable: a saddle of the energy":["instabil: ein Sattel der Energie","inestable: un punto de silla de la energ\xEDa","instable\xA0: un col de l'\xE9nergie"],"nutation: L goes round it in the body every":["Nutation: L uml\xE4uft sie im K\xF6rper alle","nutaci\xF3n: L le da la vuelta en el cuerpo cada","nutation\xA0: L en fait le tour dans le corps toutes les"],"{quantity}, change in 20 turns":["{quantity}, \xC4nderung in 20 Umdrehungen","{quantity}, cambio en 20 vueltas","{quantity}, variation en 20 tours"],"weight \xD7 distance to the centre of mass":["Gewicht \xD7 Abstand zum Schwerpunkt","peso \xD7 distancia al centro de masas","poids \xD7 distance au centre de masse"],"axis leans":["Neigung der Achse","inclinaci\xF3n del eje","inclinaison de l'axe"],"nutation: nods every":["Nutation: nickt alle","nutaci\xF3n: cabecea cada","nutation\xA0: oscille toutes les"],"mean precession":["mittlere Pr\xE4zession","precesi\xF3n media","pr\xE9cession moyenne"],"a gyroscope's, mgl/I\u2083\u03C9":["die eines Gyroskops, mgl/I\u2083\u03C9","la de un gir\xF3scopo, mgl/I\u2083\u03C9","celle d'un gyroscope, mgl/I\u2083\u03C9"],"upright at this spin, to first order":["aufrecht bei dieser Drehung, in erster Ordnung","vertical con este giro, a primer orden","debout \xE0 cette rotation, au premier ordre"],"stable: it would sleep":["stabil: er w\xFCrde schlafen","estable: dormir\xEDa","stable\xA0: elle dormirait"],"unstable: it would fall":["instabil: er w\xFCrde fallen","inestable: caer\xEDa","instable\xA0: elle tomberait"],"moment of inertia across, at the point":["Tr\xE4gheits\xADmoment quer, im St\xFCtzpunkt","momento de inercia transversal, en la punta","moment d'inertie transverse, \xE0 la pointe"],"moment of inertia about the axis":["Tr\xE4gheits\xADmoment um die Achse","momento de inercia respecto al eje","moment d'inertie autour de l'axe"],lean:["Neigung","inclinaci\xF3n","inclinaison"],"spin about its axis":["Eigendrehung","rotaci\xF3n propia","rotation propre"],"precession at the start":["Pr\xE4zession am Anfang","precesi\xF3n al inicio","pr\xE9cession au d\xE9part"],"nutation at the start":["Nutation am Anfang","nutaci\xF3n al inicio","nutation au d\xE9part"],"stands upright and spins":["steht aufrecht und dreht sich","se mantiene vertical y gira","se tient debout et tourne"],"hangs and spins":["h\xE4ngt und dreht sich","cuelga y gira","pend et tourne"],"goes round at constant lean":["pr\xE4zediert mit gleicher Neigung","precesa con inclinaci\xF3n constante","pr\xE9cesse \xE0 inclinaison constante"],"no weight: turns freely":["kein Gewicht: dreht sich frei","sin peso: gira libremente","sans poids\xA0: tourne librement"],"swings like a pendulum":["schwingt wie ein Pendel","oscila como un p\xE9ndulo","oscille comme un pendule"],"nods while it goes round, always onward":["nickt beim Pr\xE4zedieren, immer vorw\xE4rts","cabecea mientras precesa, siempre hacia delante","nute en pr\xE9cessant, toujours vers l'avant"],"nods, halting at cusps":["nickt und h\xE4lt in Spitzen an","cabecea, deteni\xE9ndose en c\xFAspides","nute, en s'arr\xEAtant aux points de rebroussement"],"nods in loops":["nickt in Schleifen","cabecea en lazos","nute en boucles"],"rises to the vertical and stays there":["richtet sich auf und bleibt aufrecht","sube a la vertical y se queda ah\xED","monte \xE0 la verticale et y reste"],"nods every":["nickt alle","cabecea cada","nute toutes les"],"sleeps upright from":["schl\xE4ft aufrecht ab","duerme vertical a partir de","dort debout \xE0 partir de"],state:["Zustand","estado","\xE9tat"],level:["Niveau","nivel","niveau"],"L as sharp as it can be":["L so scharf wie m\xF6glich","L tan definido como es posible","L aussi d\xE9fini que possible"],"L leans from the b axis by":["Neigung von L gegen die b-Achse","inclinaci\xF3n de L sobre el eje b","inclinaison de L sur l'axe b"],"towards (0\xB0 is a, 90\xB0 is c)":["in Richtung (0\xB0 ist a, 90\xB0 ist c)","hacia (0\xB0 es a, 90\xB0 es c)","vers (0\xB0\xA0: a, 90\xB0\xA0: c)"],"classical energy E/hc":["klassische Energie E/hc","energ\xEDa cl\xE1sica E/hc","\xE9nergie classique E/hc"],"classical L goes round its polhode in":["klassisches L uml\xE4uft seine Polhodie in","L cl\xE1sico recorre su polhodia en","L classique parcourt sa polhodie en"],"energy E/hc":["Energie E/hc","energ\xEDa E/hc","\xE9nergie E/hc"],"energy E/hc, rigid rotor":["Energie E/hc, starrer Rotator","energ\xEDa E/hc, rotor r\xEDgido","\xE9nergie E/hc, rotateur rigide"],"as a quantised polhode":["als quantisierte Polhodie","como polhodia cuantizada","comme polhodie quantifi\xE9e"],"L goes round":["L uml\xE4uft","L rodea","L tourne autour de"],"the a axis, above the saddle":["die a-Achse, \xFCber dem Sattel","el eje a, por encima de la silla","l'axe a, au-dessus du col"],"the c axis, below the saddle":["die c-Achse, unter dem Sattel","el eje c, por debajo de la silla","l'axe c, au-dessous du col"],"step to the next of its ladder":["Abstand zur n\xE4chsten Stufe der Leiter","paso al siguiente de su escalera","\xE9cart au niveau suivant de son \xE9chelle"],"turns of L a second, half way there":["Uml\xE4ufe von L je Sekunde, auf halbem Weg","vueltas de L por segundo, a medio camino","tours de L par seconde, \xE0 mi-chemin"],"tunnelling splits the pair by":["Tunneln spaltet das Paar um","el efecto t\xFAnel separa el par en","l'effet tunnel s\xE9pare la paire de"],"\u27E8L_b\u27E9 falls to J/2 after":["\u27E8L_b\u27E9 f\xE4llt auf J/2 nach","\u27E8L_b\u27E9 cae a J/2 tras","\u27E8L_b\u27E9 tombe \xE0 J/2 apr\xE8s"],"first reversal":["erste Umkehr","primera inversi\xF3n","premier retournement"],"{time}, to \u27E8L_b\u27E9 = {value} J":["{time}, bis \u27E8L_b\u27E9 = {value} J","{time}, hasta \u27E8L_b\u27E9 = {value} J","{time}, jusqu'\xE0 \u27E8L_b\u27E9 = {value} J"],"revival T_rev":["Wiederkehr T_rev","resurgimiento T_rev","renaissance T_rev"],"tilt of the face at first":["Neigung der Fl\xE4che am Anfang","inclinaci\xF3n de la cara al inicio","inclinaison de la face au d\xE9part"],radius:["Radius","radio","rayon"],thickness:["Dicke","espesor","\xE9paisseur"],mass:["Masse","masa","masse"],gravity:["Fall\xADbeschleunigung","gravedad","pesanteur"],"viscosity of the air":["Z\xE4higkeit der Luft","viscosidad del aire","viscosit\xE9 de l'air"],"loss in the boundary layer":["Verlust in der Grenzschicht","p\xE9rdida en la capa l\xEDmite","perte dans la couche limite"],"viscous friction of the contact":["viskose Reibung am Ber\xFChrpunkt","fricci\xF3n viscosa del contacto","frottement visqueux du contact"],"dry friction of the contact":["trockene Reibung am Ber\xFChrpunkt","fricci\xF3n seca del contacto","frottement sec du contact"],"lever arm of rolling friction":["Hebelarm der Rollreibung","brazo de la fricci\xF3n de rodadura","bras de levier du frottement de roulement"],"lever arm of drilling friction":["Hebelarm der Bohrreibung","brazo de la fricci\xF3n de pivoteo","bras de levier du frottement de pivotement"],"contact goes round every":["Ber\xFChrpunkt l\xE4uft um alle","el contacto da la vuelta cada","le contact fait le tour toutes les"],"energy at first":["Energie am Anfang","energ\xEDa al inicio","\xE9nergie au d\xE9part"],"energy less losses, change in 20 rounds":["Energie ohne Verluste, \xC4nderung in 20 Uml\xE4ufen","energ\xEDa sin p\xE9rdidas, cambio en 20 vueltas","\xE9nergie hors pertes, variation en 20 tours"],"lost in 20 rounds":["verloren in 20 Uml\xE4ufen","perdido en 20 vueltas","perdu en 20 tours"],ends:["endet","termina","se termine"],"flat on the table, within 20 rounds":["flach auf dem Tisch, binnen 20 Uml\xE4ufen","plano sobre la mesa, en menos de 20 vueltas","\xE0 plat sur la table, en moins de 20 tours"],"by {event}, within 20 rounds":["durch {event}, binnen 20 Uml\xE4ufen","por {event}, en menos de 20 vueltas","par {event}, en moins de 20 tours"],"Open a gyro log\u2026":["Gyro-Aufzeichnung \xF6ffnen\u2026","Abrir un registro de gir\xF3scopo\u2026","Ouvrir un relev\xE9 de gyroscope\u2026"],"or drop it on this page: phyphox, Sensor Logger, AndroSensor, Betaflight, or any table with a time and three angular velocities. It stays on this computer.":["oder auf diese Seite ziehen: phyphox, Sensor Logger, AndroSensor, Betaflight oder jede Tabelle mit einer Zeit und drei Winkelgeschwindigkeiten. Sie bleibt auf diesem Rechner.","o su\xE9ltelo en esta p\xE1gina: phyphox, Sensor Logger, AndroSensor, Betaflight o cualquier tabla con un tiempo y tres velocidades angulares. Se queda en este ordenador.","ou d\xE9posez-le sur cette page\xA0: phyphox, Sensor Logger, AndroSensor, Betaflight, ou toute table avec un temps et trois vitesses angulaires. Il reste sur cet ordinateur."],"A log of your own":["Eine eigene Aufzeichnung","Un registro propio","Un relev\xE9 \xE0 vous"],"Columns and units":["Spalten und Einheiten","Columnas y unidades","Colonnes et unit\xE9s"],"Read the log":["Aufzeichnung lesen","Leer el registro","Lire le relev\xE9"],"choose\u2026":["w\xE4hlen\u2026","elegir\u2026","choisir\u2026"],"fitting\u2026":["wird angepasst\u2026","ajustando\u2026","ajustement\u2026"],time:["Zeit","tiempo","temps"],"unit of the time":["Einheit der Zeit","unidad del tiempo","unit\xE9 du temps"],"angular velocity, given axes":["Winkelgeschwindigkeit, gegebene Achsen","velocidad angular, ejes dados","vitesse angulaire, axes donn\xE9s"],"pointing error":["Ausrichtungsfehler","error de apuntamiento","erreur de pointage"],"rates of the wheels":["Drehraten der R\xE4der","velocidades de las ruedas","vitesses des roues"],"angular velocity x":["Winkelgeschwindigkeit x","velocidad angular x","vitesse angulaire x"],"angular velocity y":["Winkelgeschwindigkeit y","velocidad angular y","vitesse angulaire y"],"angular velocity z":["Winkelgeschwindigkeit z","velocidad angular z","vitesse angulaire z"],"its unit":["ihre Einheit","su unidad","son unit\xE9"],"which throw":["welcher Wurf","qu\xE9 lanzamiento","quel lancer"],"column {column}":["Spalte {column}","columna {column}","colonne {column}"],"line {line}, {column}":["Zeile {line}, {column}","l\xEDnea {line}, {column}","ligne {line}, {column}"],times:["Zeiten","tiempos","temps"],rates:["Drehraten","velocidades angulares","vitesses angulaires"],accelerations:["Beschleunigungen","aceleraciones","acc\xE9l\xE9rations"],"no app that is known writes such a header. Choose what the columns are, and the units that the file does not say.":["Keine bekannte App schreibt so eine Kopfzeile. W\xE4hlen Sie, was die Spalten sind, und die Einheiten, die die Datei nicht nennt.","ninguna aplicaci\xF3n conocida escribe un encabezado as\xED. Elija qu\xE9 son las columnas y las unidades que el archivo no dice.","aucune application connue n'\xE9crit un tel en-t\xEAte. Choisissez ce que sont les colonnes, et les unit\xE9s que le fichier ne dit pas."],"it has {size} MB, and at most {most} MB are read. Cut the log to the throw.":["Sie hat {size} MB, und h\xF6chstens {most} MB werden gelesen. K\xFCrzen Sie die Aufzeichnung auf den Wurf.","tiene {size} MB, y se leen como mucho {most} MB. Recorte el registro al lanzamiento.","il a {size} Mo, et au plus {most} Mo sont lus. R\xE9duisez le relev\xE9 au lancer."],"it is a zip archive. Unpack it, and choose the table inside, like Gyroscope.csv or Raw Data.csv.":["Das ist ein ZIP-Archiv. Entpacken Sie es, und w\xE4hlen Sie die Tabelle darin, etwa Gyroscope.csv oder Raw Data.csv.","es un archivo zip. Descompr\xEDmalo y elija la tabla de dentro, como Gyroscope.csv o Raw Data.csv.","c'est une archive zip. D\xE9compressez-la, et choisissez la table qu'elle contient, comme Gyroscope.csv ou Raw Data.csv."],"no sample stands below the header in line {line}. Log again.":["Unter der Kopfzeile in Zeile {line} steht kein Messwert. Zeichnen Sie noch einmal auf.","no hay ninguna medida bajo el encabezado de la l\xEDnea {line}. Registre de nuevo.","aucune mesure sous l'en-t\xEAte de la ligne {line}. Refaites le relev\xE9."],"it is not known which columns have the time and the angular velocities: no app that is known writes such a header. Choose them.":["Es ist nicht bekannt, welche Spalten die Zeit und die Winkelgeschwindigkeiten haben: Keine bekannte App schreibt so eine Kopfzeile. W\xE4hlen Sie sie.","no se sabe qu\xE9 columnas tienen el tiempo y las velocidades angulares: ninguna aplicaci\xF3n conocida escribe un encabezado as\xED. El\xEDjalas.","on ne sait pas quelles colonnes ont le temps et les vitesses angulaires\xA0: aucune application connue n'\xE9crit un tel en-t\xEAte. Choisissez-les."],"{column} is chosen twice. Choose another column for each.":["{column} ist zweimal gew\xE4hlt. W\xE4hlen Sie f\xFCr jede Gr\xF6\xDFe eine andere Spalte.","{column} est\xE1 elegida dos veces. Elija otra columna para cada magnitud.","{column} est choisie deux fois. Choisissez une autre colonne pour chaque grandeur."],"the unit of the angular velocity is not known: the file does not say it. Choose deg/s, rad/s or rpm.":["Die Einheit der Winkelgeschwindigkeit ist nicht bekannt: Die Datei nennt sie nicht. W\xE4hlen Sie deg/s, rad/s oder rpm.","no se conoce la unidad de la velocidad angular: el archivo no la dice. Elija deg/s, rad/s o rpm.","l'unit\xE9 de la vitesse angulaire est inconnue\xA0: le fichier ne la dit pas. Choisissez deg/s, rad/s ou rpm."],"the unit of the time is not known: the file does not say it. Choose it.":["Die Einheit der Zeit ist nicht bekannt: Die Datei nennt sie nicht. W\xE4hlen Sie sie.","no se conoce la unidad del tiempo: el archivo no la dice. El\xEDjala.","l'unit\xE9 du temps est inconnue\xA0: le fichier ne la dit pas. Choisissez-la."],"a gyro log must have {least} finite samples at different times; this one has {count}. Log for longer.":["Eine Gyro-Aufzeichnung muss {least} endliche Messwerte zu verschiedenen Zeiten haben; diese hat {count}. Zeichnen Sie l\xE4nger auf.","un registro de gir\xF3scopo debe tener {least} medidas finitas en tiempos distintos; este tiene {count}. Registre m\xE1s tiempo.","un relev\xE9 de gyroscope doit avoir {least} mesures finies \xE0 des temps diff\xE9rents\xA0; celui-ci en a {count}. Enregistrez plus longtemps."],"Accelerations are left out, as their unit is not known.":["Beschleunigungen bleiben weg, da ihre Einheit nicht bekannt ist.","Se omiten las aceleraciones, pues no se conoce su unidad.","Les acc\xE9l\xE9rations sont omises, car leur unit\xE9 est inconnue."],"{count} lines without finite values are left out.":["{count} Zeilen ohne endliche Werte bleiben weg.","Se omiten {count} l\xEDneas sin valores finitos.","{count} lignes sans valeurs finies sont omises."],"times of {what} must lie {least} s apart or more; got {got} s. Check which column has the times, and their unit.":["Zeiten der {what} m\xFCssen {least} s oder mehr auseinander liegen; hier sind es {got} s. Pr\xFCfen Sie, welche Spalte die Zeiten hat, und deren Einheit.","los tiempos de las {what} deben distar {least} s o m\xE1s; aqu\xED distan {got} s. Compruebe qu\xE9 columna tiene los tiempos y su unidad.","les temps des {what} doivent \xEAtre espac\xE9s d'au moins {least} s\xA0; ici {got} s. V\xE9rifiez quelle colonne a les temps, et leur unit\xE9."],"Lines are not in the order of time; they were sorted.":["Die Zeilen stehen nicht in zeitlicher Reihenfolge; sie wurden sortiert.","Las l\xEDneas no est\xE1n en orden temporal; se han ordenado.","Les lignes ne sont pas dans l'ordre du temps\xA0; elles ont \xE9t\xE9 tri\xE9es."],"{count} samples come at a time that was there already; the first of each is kept.":["{count} Messwerte kommen zu einer Zeit, die es schon gab; der jeweils erste wird behalten.","{count} medidas llegan en un tiempo que ya estaba; se conserva la primera de cada uno.","{count} mesures arrivent \xE0 un temps d\xE9j\xE0 pr\xE9sent\xA0; la premi\xE8re de chacun est gard\xE9e."],"The clock is rounded: {count} samples come at a time that was there already, with other values; they are taken at equal steps.":["Die Uhr ist gerundet: {count} Messwerte kommen zu einer Zeit, die es schon gab, mit anderen Werten; sie werden in gleichen Schritten genommen.","El reloj est\xE1 redondeado: {count} medidas llegan en un tiempo que ya estaba, con otros valores; se toman a pasos iguales.","L'horloge est arrondie\xA0: {count} mesures arrivent \xE0 un temps d\xE9j\xE0 pr\xE9sent, avec d'autres valeurs\xA0; elles sont prises \xE0 pas \xE9gaux."],"{what} must be at most {most} in SI units; got {got}. Check which columns they are, and their unit.":["{what} d\xFCrfen h\xF6chstens {most} in SI-Einheiten sein; hier {got}. Pr\xFCfen Sie, welche Spalten es sind, und ihre Einheit.","{what}: como mucho {most} en unidades SI; aqu\xED {got}. Compruebe qu\xE9 columnas son y su unidad.","{what}\xA0: au plus {most} en unit\xE9s SI\xA0; ici {got}. V\xE9rifiez quelles colonnes ce sont, et leur unit\xE9."],"line {line} is not UTF-8 text, so this is not a table. Choose the app's CSV file, unpacked from its archive.":["Zeile {line} ist kein UTF-8-Text, also ist dies keine Tabelle. W\xE4hlen Sie die CSV-Datei der App, aus ihrem Archiv entpackt.","la l\xEDnea {line} no es texto UTF-8, as\xED que esto no es una tabla. Elija el archivo CSV de la aplicaci\xF3n, extra\xEDdo de su archivo comprimido.","la ligne {line} n'est pas du texte UTF-8, donc ce n'est pas une table. Choisissez le fichier CSV de l'application, extrait de son archive."],"line {line} has more than {most} characters. Choose a table with one sample in each line.":["Zeile {line} hat mehr als {most} Zeichen. W\xE4hlen Sie eine Tabelle mit einem Messwert je Zeile.","la l\xEDnea {line} tiene m\xE1s de {most} caracteres. Elija una tabla con una medida por l\xEDnea.","la ligne {line} a plus de {most} caract\xE8res. Choisissez une table avec une mesure par ligne."],"its first line is {text}":["ihre erste Zeile ist {text}","su primera l\xEDnea es {text}","sa premi\xE8re ligne est {text}"],"it is empty":["sie ist leer","est\xE1 vac\xEDo","il est vide"],"it has no line of numbers in two columns or more, between commas, semicolons, tabs or blanks; {first}. Choose a table with one sample in each line.":["Sie hat keine Zeile mit Zahlen in zwei oder mehr Spalten, zwischen Kommas, Strichpunkten, Tabulatoren oder Leerzeichen; {first}. W\xE4hlen Sie eine Tabelle mit einem Messwert je Zeile.","no tiene ninguna l\xEDnea de n\xFAmeros en dos columnas o m\xE1s, entre comas, puntos y comas, tabuladores o espacios; {first}. Elija una tabla con una medida por l\xEDnea.","il n'a pas de ligne de nombres en deux colonnes ou plus, entre virgules, points-virgules, tabulations ou espaces\xA0; {first}. Choisissez une table avec une mesure par ligne."],"line {line} must name the {columns} columns that line {first} has; got {names} names. Name each, or delete the line.":["Zeile {line} muss die {columns} Spalten benennen, die Zeile {first} hat; hier sind es {names} Namen. Benennen Sie jede, oder l\xF6schen Sie die Zeile.","la l\xEDnea {line} debe nombrar las {columns} columnas que tiene la l\xEDnea {first}; tiene {names} nombres. Nombre cada una o borre la l\xEDnea.","la ligne {line} doit nommer les {columns} colonnes de la ligne {first}\xA0; elle a {names} noms. Nommez chacune, ou supprimez la ligne."],"line {line} has quotes that do not close. Check the line.":["Zeile {line} hat Anf\xFChrungszeichen, die nicht schlie\xDFen. Pr\xFCfen Sie die Zeile.","la l\xEDnea {line} tiene comillas que no se cierran. Compruebe la l\xEDnea.","la ligne {line} a des guillemets qui ne se ferment pas. V\xE9rifiez la ligne."],"line {line} has {cells} cells, and line {first} has {width}. Check the line, or delete it.":["Zeile {line} hat {cells} Zellen, und Zeile {first} hat {width}. Pr\xFCfen Sie die Zeile, oder l\xF6schen Sie sie.","la l\xEDnea {line} tiene {cells} celdas, y la l\xEDnea {first} tiene {width}. Compruebe la l\xEDnea o b\xF3rrela.","la ligne {line} a {cells} cellules, et la ligne {first} en a {width}. V\xE9rifiez la ligne, ou supprimez-la."],"line {line} has {cells} cells, and line {first} has {width}. Check the line, or delete it. Is the comma a decimal one? Then save it with semicolons.":["Zeile {line} hat {cells} Zellen, und Zeile {first} hat {width}. Pr\xFCfen Sie die Zeile, oder l\xF6schen Sie sie. Ist das Komma ein Dezimalkomma? Dann speichern Sie mit Strichpunkten.","la l\xEDnea {line} tiene {cells} celdas, y la l\xEDnea {first} tiene {width}. Compruebe la l\xEDnea o b\xF3rrela. \xBFEs la coma decimal? Entonces gu\xE1rdela con puntos y comas.","la ligne {line} a {cells} cellules, et la ligne {first} en a {width}. V\xE9rifiez la ligne, ou supprimez-la. La virgule est-elle d\xE9cimale\xA0? Alors enregistrez avec des points-virgules."],"{where}: {cell} has a point, and the other numbers have decimal commas. Choose one of them.":["{where}: {cell} hat einen Punkt, und die anderen Zahlen haben Dezimalkommas. W\xE4hlen Sie eins davon.","{where}: {cell} tiene un punto, y los otros n\xFAmeros tienen comas decimales. Elija uno de los dos.","{where}\xA0: {cell} a un point, et les autres nombres ont des virgules d\xE9cimales. Choisissez l'un des deux."],"must be a number in decimal digits":["muss eine Zahl in Dezimalziffern sein","debe ser un n\xFAmero en cifras decimales","doit \xEAtre un nombre en chiffres d\xE9cimaux"],"is so small that nothing is left of it":["ist so klein, dass nichts davon \xFCbrig bleibt","es tan peque\xF1o que no queda nada de \xE9l","est si petit qu'il n'en reste rien"],"is too large for a number":["ist zu gro\xDF f\xFCr eine Zahl","es demasiado grande para un n\xFAmero","est trop grand pour un nombre"],"Dates and times of day are not read: give times as plain numbers, like seconds from the start.":["Datum und Uhrzeit werden nicht gelesen: Geben Sie Zeiten als einfache Zahlen an, etwa Sekunden vom Anfang an.","No se leen fechas ni horas: d\xE9 los tiempos como n\xFAmeros, por ejemplo segundos desde el inicio.","Les dates et heures ne sont pas lues\xA0: donnez les temps en simples nombres, comme des secondes depuis le d\xE9part."],"Correct it, or leave the cell blank.":["Berichtigen Sie sie, oder lassen Sie die Zelle leer.","Corr\xEDjala o deje la celda en blanco.","Corrigez-la, ou laissez la cellule vide."],"keeps an angular momentum":["beh\xE4lt einen Drehimpuls","conserva un momento angular","conserve un moment cin\xE9tique"],"the accelerometer feels no weight":["der Beschleunigungsmesser sp\xFCrt kein Gewicht","el aceler\xF3metro no siente peso","l'acc\xE9l\xE9rom\xE8tre ne sent aucun poids"],"no free flight was found in the log: no stretch of a quarter of a second keeps an angular momentum, or feels no weight. Throw it with a spin of a turn a second or more, and log from before the throw until after the catch.":["In der Aufzeichnung wurde kein freier Flug gefunden: Kein Abschnitt von einer Viertelsekunde beh\xE4lt einen Drehimpuls oder sp\xFCrt kein Gewicht. Werfen Sie mit einer Umdrehung je Sekunde oder mehr, und zeichnen Sie von vor dem Wurf bis nach dem Fangen auf.","no se ha hallado ning\xFAn vuelo libre en el registro: ning\xFAn tramo de un cuarto de segundo conserva un momento angular o no siente peso. Lance con una vuelta por segundo o m\xE1s, y registre desde antes del lanzamiento hasta despu\xE9s de la captura.","aucun vol libre n'a \xE9t\xE9 trouv\xE9 dans le relev\xE9\xA0: aucun intervalle d'un quart de seconde ne conserve un moment cin\xE9tique ou ne sent aucun poids. Lancez avec un tour par seconde ou plus, et enregistrez d'avant le lancer jusqu'apr\xE8s la r\xE9ception."],"a throw must have {least} samples that are not at the gyro's limit; got {count}. Throw more slowly.":["Ein Wurf muss {least} Messwerte haben, die nicht an der Grenze des Gyros liegen; hier sind es {count}. Werfen Sie langsamer.","un lanzamiento debe tener {least} medidas que no est\xE9n en el l\xEDmite del gir\xF3scopo; hay {count}. Lance m\xE1s despacio.","un lancer doit avoir {least} mesures hors de la limite du gyroscope\xA0; ici {count}. Lancez plus lentement."],"no free motion of a rigid body explains the log: the residuals, {residuals} rad/s, are not small beside the rates, {rates} rad/s. Check columns and units, or log a free flight.":["Keine freie Bewegung eines starren K\xF6rpers erkl\xE4rt die Aufzeichnung: Die Residuen, {residuals} rad/s, sind nicht klein gegen die Drehraten, {rates} rad/s. Pr\xFCfen Sie Spalten und Einheiten, oder zeichnen Sie einen freien Flug auf.","ning\xFAn movimiento libre de un s\xF3lido r\xEDgido explica el registro: los residuos, {residuals} rad/s, no son peque\xF1os frente a las velocidades, {rates} rad/s. Compruebe columnas y unidades, o registre un vuelo libre.","aucun mouvement libre d'un solide n'explique le relev\xE9\xA0: les r\xE9sidus, {residuals} rad/s, ne sont pas petits devant les vitesses, {rates} rad/s. V\xE9rifiez colonnes et unit\xE9s, ou enregistrez un vol libre."],"{times} times the noise of a sample":["{times}-mal das Rauschen eines Messwerts","{times} veces el ruido de una medida","{times} fois le bruit d'une mesure"],"alike from sample to sample (correlation {correlation})":["von Messwert zu Messwert \xE4hnlich (Korrelation {correlation})","parecidos de una medida a otra (correlaci\xF3n {correlation})","semblables d'une mesure \xE0 l'autre (corr\xE9lation {correlation})"],"larger than the noise at a few samples, up to {most} rad/s":["bei einigen Messwerten gr\xF6\xDFer als das Rauschen, bis {most} rad/s","mayores que el ruido en algunas medidas, hasta {most} rad/s","plus grands que le bruit \xE0 quelques mesures, jusqu'\xE0 {most} rad/s"],"The log is not the motion of a rigid body with drag within its noise: the residuals ({rms} rad/s rms, noise {noise} rad/s) are {why}.":["Die Aufzeichnung ist innerhalb ihres Rauschens nicht die Bewegung eines starren K\xF6rpers mit Luftwiderstand: Die Residuen ({rms} rad/s rms, Rauschen {noise} rad/s) sind {why}.","El registro no es, dentro de su ruido, el movimiento de un s\xF3lido r\xEDgido con arrastre: los residuos ({rms} rad/s rms, ruido {noise} rad/s) son {why}.","Le relev\xE9 n'est pas, au bruit pr\xE8s, le mouvement d'un solide avec tra\xEEn\xE9e\xA0: les r\xE9sidus ({rms} rad/s rms, bruit {noise} rad/s) sont {why}."],"The log is not a free rigid body's motion within its noise: the residuals ({rms} rad/s rms, noise {noise} rad/s) are {why}.":["Die Aufzeichnung ist innerhalb ihres Rauschens nicht die Bewegung eines freien starren K\xF6rpers: Die Residuen ({rms} rad/s rms, Rauschen {noise} rad/s) sind {why}.","El registro no es, dentro de su ruido, el movimiento de un s\xF3lido r\xEDgido libre: los residuos ({rms} rad/s rms, ruido {noise} rad/s) son {why}.","Le relev\xE9 n'est pas, au bruit pr\xE8s, le mouvement d'un solide libre\xA0: les r\xE9sidus ({rms} rad/s rms, bruit {noise} rad/s) sont {why}."],"A gyro's gains, a clock that jitters or a catch within the window do that; polhode fit fits gains too, and gives errors.":["Verst\xE4rkungen des Gyros, eine unruhige Uhr oder ein Fangen im Zeitfenster bewirken das; polhode fit passt auch Verst\xE4rkungen an und gibt Fehler an.","Las ganancias del gir\xF3scopo, un reloj irregular o una captura dentro de la ventana lo causan; polhode fit ajusta tambi\xE9n las ganancias y da los errores.","Les gains du gyroscope, une horloge irr\xE9guli\xE8re ou une r\xE9ception dans la fen\xEAtre en sont la cause\xA0; polhode fit ajuste aussi les gains, et donne les erreurs."],"The rates say that the body turns by {angle} rad from sample to sample, too far to be followed: the rates are of another unit, like deg/s, or the times are.":["Den Drehraten nach dreht sich der K\xF6rper von Messwert zu Messwert um {angle} rad, zu weit, um ihm zu folgen: Die Drehraten haben eine andere Einheit, etwa deg/s, oder die Zeiten.","Seg\xFAn las velocidades, el cuerpo gira {angle} rad de una medida a otra, demasiado para seguirlo: las velocidades est\xE1n en otra unidad, como deg/s, o lo est\xE1n los tiempos.","D'apr\xE8s les vitesses, le corps tourne de {angle} rad d'une mesure \xE0 l'autre, trop pour \xEAtre suivi\xA0: les vitesses sont dans une autre unit\xE9, comme deg/s, ou les temps le sont."],"The rates, about {rates} rad/s, are beyond what gyros can tell, and make the body nearly a sphere. Both happen where rates in deg/s are read as rad/s: choose their unit.":["Die Drehraten, etwa {rates} rad/s, liegen \xFCber dem, was Gyros messen, und machen den K\xF6rper fast zur Kugel. Beides geschieht, wo Drehraten in deg/s als rad/s gelesen werden: W\xE4hlen Sie ihre Einheit.","Las velocidades, unos {rates} rad/s, superan lo que miden los gir\xF3scopos y hacen del cuerpo casi una esfera. Ambas cosas ocurren cuando velocidades en deg/s se leen como rad/s: elija su unidad.","Les vitesses, environ {rates} rad/s, d\xE9passent ce que mesurent les gyroscopes, et font du corps presque une sph\xE8re. Cela arrive quand des vitesses en deg/s sont lues en rad/s\xA0: choisissez leur unit\xE9."],"The body turned by {angle} rad only: nothing can be said of its inertia.":["Der K\xF6rper hat sich nur um {angle} rad gedreht: \xDCber seine Tr\xE4gheit l\xE4sst sich nichts sagen.","El cuerpo solo ha girado {angle} rad: nada puede decirse de su inercia.","Le corps n'a tourn\xE9 que de {angle} rad\xA0: on ne peut rien dire de son inertie."],"The rates ({rates} rad/s) stay within {angle}\xB0 of one direction of the device, {axis}: the body spins about a principal axis, or is a sphere; either way the log does not determine the moments. Throw it with a tumble, best about its middle axis.":["Die Drehraten ({rates} rad/s) bleiben innerhalb von {angle}\xB0 um eine Richtung des Ger\xE4ts, {axis}: Der K\xF6rper dreht sich um eine Hauptachse, oder er ist ein Kugelkreisel; so oder so bestimmt die Aufzeichnung die Tr\xE4gheitsmomente nicht. Werfen Sie ihn taumelnd, am besten um seine mittlere Achse.","Las velocidades ({rates} rad/s) se mantienen a menos de {angle}\xB0 de una direcci\xF3n del aparato, {axis}: el cuerpo gira en torno a un eje principal, o es una esfera; en ambos casos el registro no determina los momentos. L\xE1ncelo dando tumbos, mejor en torno a su eje intermedio.","Les vitesses ({rates} rad/s) restent \xE0 moins de {angle}\xB0 d'une direction de l'appareil, {axis}\xA0: le corps tourne autour d'un axe principal, ou c'est une sph\xE8re\xA0; dans les deux cas le relev\xE9 ne d\xE9termine pas les moments. Lancez-le en le faisant culbuter, de pr\xE9f\xE9rence autour de son axe interm\xE9diaire."],"Within the noise, bodies of quite different moments fit the rates ({rates} rad/s, up to {angle}\xB0 from {axis}). Throw it longer or faster, with a tumble about its middle axis.":["Innerhalb des Rauschens passen K\xF6rper mit recht verschiedenen Tr\xE4gheitsmomenten zu den Drehraten ({rates} rad/s, bis {angle}\xB0 von {axis}). Werfen Sie ihn l\xE4nger oder schneller, taumelnd um seine mittlere Achse.","Dentro del ruido, cuerpos de momentos bastante distintos se ajustan a las velocidades ({rates} rad/s, hasta {angle}\xB0 de {axis}). L\xE1ncelo m\xE1s tiempo o m\xE1s r\xE1pido, dando tumbos en torno a su eje intermedio.","Au bruit pr\xE8s, des corps de moments assez diff\xE9rents conviennent aux vitesses ({rates} rad/s, jusqu'\xE0 {angle}\xB0 de {axis}). Lancez-le plus longtemps ou plus vite, en culbute autour de son axe interm\xE9diaire."],"Free flight from {begin} s to {end} s of the log, and the exact motion of the fitted body: {ratios}.":["Freier Flug von {begin} s bis {end} s der Aufzeichnung, und die exakte Bewegung des angepassten K\xF6rpers: {ratios}.","Vuelo libre de {begin} s a {end} s del registro, y el movimiento exacto del cuerpo ajustado: {ratios}.","Vol libre de {begin} s \xE0 {end} s du relev\xE9, et le mouvement exact du corps ajust\xE9\xA0: {ratios}."],"A gyro tells the moments up to a common factor: on this page the largest is 1 kg m\xB2.":["Ein Gyro bestimmt die Tr\xE4gheitsmomente bis auf einen gemeinsamen Faktor: Auf dieser Seite ist das gr\xF6\xDFte 1 kg m\xB2.","Un gir\xF3scopo da los momentos salvo un factor com\xFAn: en esta p\xE1gina el mayor es 1 kg m\xB2.","Un gyroscope donne les moments \xE0 un facteur commun pr\xE8s\xA0: sur cette page le plus grand vaut 1 kg m\xB2."],"Read as a log of {app}, rates in {unit}.":["Gelesen als Aufzeichnung von {app}, Drehraten in {unit}.","Le\xEDdo como registro de {app}, velocidades en {unit}.","Lu comme relev\xE9 de {app}, vitesses en {unit}."],"Rates are read in {unit}, as chosen.":["Drehraten werden in {unit} gelesen, wie gew\xE4hlt.","Las velocidades se leen en {unit}, como se ha elegido.","Les vitesses sont lues en {unit}, comme choisi."],"{count} free flights are found; this one lasts {duration} s: {reason}.":["{count} freie Fl\xFCge sind gefunden; dieser dauert {duration} s: {reason}.","Se hallan {count} vuelos libres; este dura {duration} s: {reason}.","{count} vols libres sont trouv\xE9s\xA0; celui-ci dure {duration} s\xA0: {reason}."],"One free flight is found; it lasts {duration} s: {reason}.":["Ein freier Flug ist gefunden; er dauert {duration} s: {reason}.","Se halla un vuelo libre; dura {duration} s: {reason}.","Un vol libre est trouv\xE9\xA0; il dure {duration} s\xA0: {reason}."],"{ratios}; the gyro's bias is {bias} rad/s, which a rest confirms.":["{ratios}; der Nullpunktfehler des Gyros ist {bias} rad/s, was eine Ruhe best\xE4tigt.","{ratios}; el sesgo del gir\xF3scopo es {bias} rad/s, lo que un reposo confirma.","{ratios}\xA0; le biais du gyroscope est {bias} rad/s, ce qu'un repos confirme."],"{ratios}; the gyro's bias is {bias} rad/s, and no rest in the log confirms it.":["{ratios}; der Nullpunktfehler des Gyros ist {bias} rad/s, und keine Ruhe in der Aufzeichnung best\xE4tigt ihn.","{ratios}; el sesgo del gir\xF3scopo es {bias} rad/s, y ning\xFAn reposo del registro lo confirma.","{ratios}\xA0; le biais du gyroscope est {bias} rad/s, et aucun repos du relev\xE9 ne le confirme."],"Drag slows it: c/I3 = {numbers} of the torque \u2212c |\u03C9| \u03C9 along the axes.":["Luftwiderstand bremst ihn: c/I3 = {numbers} des Drehmoments \u2212c |\u03C9| \u03C9 entlang der Achsen.","El arrastre lo frena: c/I3 = {numbers} del momento \u2212c |\u03C9| \u03C9 seg\xFAn los ejes.","La tra\xEEn\xE9e le ralentit\xA0: c/I3 = {numbers} du moment \u2212c |\u03C9| \u03C9 selon les axes."],"The curves are of the free motion that touches it in the middle of the flight.":["Die Kurven sind die der freien Bewegung, die sie in der Mitte des Flugs ber\xFChrt.","Las curvas son las del movimiento libre que lo toca en la mitad del vuelo.","Les courbes sont celles du mouvement libre qui lui est tangent au milieu du vol."],"The residuals, {rms} rad/s rms, are those of the noise, {noise} rad/s: within it the log is the motion of a rigid body with drag.":["Die Residuen, {rms} rad/s rms, sind die des Rauschens, {noise} rad/s: Innerhalb davon ist die Aufzeichnung die Bewegung eines starren K\xF6rpers mit Luftwiderstand.","Los residuos, {rms} rad/s rms, son los del ruido, {noise} rad/s: dentro de \xE9l, el registro es el movimiento de un s\xF3lido r\xEDgido con arrastre.","Les r\xE9sidus, {rms} rad/s rms, sont ceux du bruit, {noise} rad/s\xA0: \xE0 celui-ci pr\xE8s, le relev\xE9 est le mouvement d'un solide avec tra\xEEn\xE9e."],"The residuals, {rms} rad/s rms, are those of the noise, {noise} rad/s: within it the log is the motion of a free rigid body.":["Die Residuen, {rms} rad/s rms, sind die des Rauschens, {noise} rad/s: Innerhalb davon ist die Aufzeichnung die Bewegung eines freien starren K\xF6rpers.","Los residuos, {rms} rad/s rms, son los del ruido, {noise} rad/s: dentro de \xE9l, el registro es el movimiento de un s\xF3lido r\xEDgido libre.","Les r\xE9sidus, {rms} rad/s rms, sont ceux du bruit, {noise} rad/s\xA0: \xE0 celui-ci pr\xE8s, le relev\xE9 est le mouvement d'un solide libre."],"Samples at the gyro's limit, {limit} deg/s, are left out; {count} remain.":["Messwerte an der Grenze des Gyros, {limit} deg/s, bleiben weg; {count} bleiben \xFCbrig.","Se omiten las medidas en el l\xEDmite del gir\xF3scopo, {limit} deg/s; quedan {count}.","Les mesures \xE0 la limite du gyroscope, {limit} deg/s, sont omises\xA0; il en reste {count}."],"T-handle":["T-Griff","Mango en T","Poign\xE9e en T"],Book:["Buch","Libro","Livre"],Phone:["Telefon","Tel\xE9fono","T\xE9l\xE9phone"],Earth:["Erde","Tierra","Terre"],Apophis:["Apophis","Apofis","Apophis"],"Spinning top":["Kreisel","Trompo","Toupie"],"Steady precession":["Regul\xE4re Pr\xE4zession","Precesi\xF3n regular","Pr\xE9cession r\xE9guli\xE8re"],Gyroscope:["Gyroskop","Gir\xF3scopo","Gyroscope"],"Dual-spin spacecraft":["Dual-Spin-Satellit","Sat\xE9lite de doble giro","Satellite \xE0 double rotation"],"Explorer 1":["Explorer 1","Explorer 1","Explorer 1"],"Euler's disk":["Euler-Scheibe","Disco de Euler","Disque d'Euler"],"Quantum racket":["Quantenschl\xE4ger","Raqueta cu\xE1ntica","Raquette quantique"],"[It spins about its intermediate axis] and turns over, again and again, although nothing acts on it.":["[Er dreht sich um seine mittlere Hauptachse] und kippt um, immer wieder, obwohl nichts auf ihn wirkt.","[Gira en torno a su eje intermedio] y se da la vuelta, una y otra vez, aunque nada act\xFAa sobre \xE9l.","[Elle tourne autour de son axe interm\xE9diaire] et se retourne, encore et encore, bien que rien n'agisse sur elle."],"[Tilt it by 5\xB0], and it still turns over, only sooner.":["[Um 5\xB0 geneigt] kippt er immer noch um, nur fr\xFCher.","[Incl\xEDnelo 5\xB0], y sigue d\xE1ndose la vuelta, solo que antes.","[Inclinez-la de 5\xB0], et elle se retourne encore, seulement plus t\xF4t."],"[By a thousandth of a degree]: it waits longer each time, but it turns over.":["[Um ein Tausendstel Grad]: Er wartet jedes Mal l\xE4nger, aber er kippt um.","[Una mil\xE9sima de grado]: cada vez espera m\xE1s, pero se da la vuelta.","[D'un milli\xE8me de degr\xE9]\xA0: elle attend plus longtemps chaque fois, mais elle se retourne."],"[About the axis of its largest moment] it never turns over: the axis cones, within 3.5\xB0 of L.":["[Um die Achse des gr\xF6\xDFten Tr\xE4gheitsmoments] kippt er nie um: Die Achse beschreibt einen Kegel, h\xF6chstens 3,5\xB0 von L.","[En torno al eje de mayor momento de inercia] nunca se da la vuelta: el eje describe un cono, a menos de 3,5\xB0 de L.","[Autour de l'axe de plus grand moment d'inertie] elle ne se retourne jamais\xA0: l'axe d\xE9crit un c\xF4ne, \xE0 moins de 3,5\xB0 de L."],"Take hold of the blue point [on the sphere] and drag it from one side of the orange curve to the other.":["Fassen Sie den blauen Punkt [auf der Kugel] und ziehen Sie ihn von einer Seite der orangen Kurve auf die andere.","Tome el punto azul [sobre la esfera] y arr\xE1strelo de un lado de la curva naranja al otro.","Saisissez le point bleu [sur la sph\xE8re] et faites-le glisser d'un c\xF4t\xE9 de la courbe orange \xE0 l'autre."],"A book [thrown about its middle axis] turns over: watch the cover turn away.":["Ein Buch, [um seine mittlere Achse geworfen], kippt um: Sehen Sie, wie der Deckel sich wegdreht.","Un libro [lanzado en torno a su eje intermedio] se da la vuelta: vea c\xF3mo se aleja la tapa.","Un livre [lanc\xE9 autour de son axe interm\xE9diaire] se retourne\xA0: regardez la couverture s'\xE9loigner."],"[Thrown about its longest axis] it keeps to it: the axis cones, within 6.3\xB0 of L.":["[Um seine l\xE4ngste Achse geworfen] bleibt es dabei: Die Achse beschreibt einen Kegel, h\xF6chstens 6,3\xB0 von L.","[Lanzado en torno a su eje m\xE1s largo] lo mantiene: el eje describe un cono, a menos de 6,3\xB0 de L.","[Lanc\xE9 autour de son axe le plus long] il s'y tient\xA0: l'axe d\xE9crit un c\xF4ne, \xE0 moins de 6,3\xB0 de L."],"[Thrown flat], like a tray, it keeps that axis as well, within 2.1\xB0.":["[Flach geworfen], wie ein Tablett, beh\xE4lt es auch diese Achse, bis auf 2,1\xB0.","[Lanzado plano], como una bandeja, tambi\xE9n mantiene ese eje, a menos de 2,1\xB0.","[Lanc\xE9 \xE0 plat], comme un plateau, il garde aussi cet axe, \xE0 2,1\xB0 pr\xE8s."],"A phone [tossed about its width] is twisted by only 14\xB0 when it has turned once, at 0.53 s. The half twist comes with the second turn: it turns over at 0.74 s.":["Ein Telefon, [um seine Breite geworfen], ist nach einer Umdrehung, bei 0,53 s, nur um 14\xB0 verdreht. Die halbe Drehung kommt mit der zweiten Umdrehung: Es kippt bei 0,74 s um.","Un tel\xE9fono [lanzado en torno a su ancho] solo se ha torcido 14\xB0 tras una vuelta, a los 0,53 s. El medio giro llega con la segunda vuelta: se da la vuelta a los 0,74 s.","Un t\xE9l\xE9phone [lanc\xE9 autour de sa largeur] n'est vrill\xE9 que de 14\xB0 apr\xE8s un tour, \xE0 0,53 s. La demi-vrille vient avec le deuxi\xE8me tour\xA0: il se retourne \xE0 0,74 s."],"[Make the tilt smaller]: the twist comes later, and a short toss does not show it.":["[Die Neigung kleiner]: Die Drehung kommt sp\xE4ter, und ein kurzer Wurf zeigt sie nicht.","[Reduzca la inclinaci\xF3n]: el giro llega m\xE1s tarde, y un lanzamiento corto no lo muestra.","[R\xE9duisez l'inclinaison]\xA0: la vrille vient plus tard, et un lancer court ne la montre pas."],"A rigid Earth's axis of rotation [goes round the axis of its shape] in some 304 days; measured, it is 433, as the Earth gives way.":["Die Drehachse einer starren Erde [uml\xE4uft ihre Figurenachse] in etwa 304 Tagen; gemessen sind es 433, da die Erde nachgibt.","El eje de rotaci\xF3n de una Tierra r\xEDgida [da la vuelta al eje de figura] en unos 304 d\xEDas; lo medido son 433, pues la Tierra cede.","L'axe de rotation d'une Terre rigide [fait le tour de l'axe de figure] en quelque 304 jours\xA0; la mesure donne 433, car la Terre se d\xE9forme."],"Its circle has a radius of 6 m at the pole. [Give it ten degrees] to see it.":["Sein Kreis hat am Pol einen Radius von 6 m. [Zehn Grad] machen ihn sichtbar.","Su c\xEDrculo tiene un radio de 6 m en el polo. [Dele diez grados] para verlo.","Son cercle a un rayon de 6 m au p\xF4le. [Donnez-lui dix degr\xE9s] pour le voir."],"The asteroid [tumbles]: it turns about L, and about itself, at periods that have nothing to do with each other.":["Der Asteroid [taumelt]: Er dreht sich um L und um sich selbst, mit Perioden, die nichts miteinander zu tun haben.","El asteroide [da tumbos]: gira en torno a L y sobre s\xED mismo, con per\xEDodos que nada tienen que ver entre s\xED.","L'ast\xE9ro\xEFde [culbute]\xA0: il tourne autour de L, et sur lui-m\xEAme, avec des p\xE9riodes sans rapport entre elles."],"[Set its spin along axis 3], and all that is left is a plain turn.":["[Die Drehung entlang Achse 3], und es bleibt nur eine einfache Drehung.","[Ponga su giro seg\xFAn el eje 3], y solo queda un giro simple.","[Mettez sa rotation selon l'axe 3], et il ne reste qu'une simple rotation."],"[Let go], the top falls, is turned aside, and comes back to rest at a cusp, again and again.":["[Losgelassen] f\xE4llt der Kreisel, wird abgelenkt und kommt in einer Spitze wieder zur Ruhe, immer wieder.","[Suelto], el trompo cae, se desv\xEDa y vuelve al reposo en una c\xFAspide, una y otra vez.","[L\xE2ch\xE9e], la toupie tombe, est d\xE9vi\xE9e, et revient au repos \xE0 un point de rebroussement, encore et encore."],"[Push it along] as you let go, and the cusps open.":["[Beim Loslassen angesto\xDFen], und die Spitzen \xF6ffnen sich.","[Emp\xFAjelo hacia delante] al soltarlo, y las c\xFAspides se abren.","[Poussez-la en avant] en la l\xE2chant, et les points de rebroussement s'ouvrent."],"[Push it back], and the axis runs in loops.":["[Zur\xFCckgesto\xDFen], und die Achse l\xE4uft in Schleifen.","[Emp\xFAjelo hacia atr\xE1s], y el eje describe lazos.","[Poussez-la en arri\xE8re], et l'axe d\xE9crit des boucles."],"[Upright and fast enough] it sleeps.":["[Aufrecht und schnell genug] schl\xE4ft er.","[Vertical y lo bastante r\xE1pido] duerme.","[Debout et assez rapide] elle dort."],"[At just the right rate] the axis goes round at constant lean.":["[Mit genau der richtigen Rate] pr\xE4zediert die Achse mit gleicher Neigung.","[Con la velocidad justa] el eje precesa con inclinaci\xF3n constante.","[\xC0 la vitesse juste] l'axe pr\xE9cesse \xE0 inclinaison constante."],"[Let go at half that rate], it nods, down to 70\xB0.":["[Mit der halben Rate losgelassen] nickt sie, bis auf 70\xB0.","[Soltada a la mitad de esa velocidad], cabecea, hasta 70\xB0.","[L\xE2ch\xE9e \xE0 la moiti\xE9 de cette vitesse], elle se balance, jusqu'\xE0 70\xB0."],"[Held at one end], the wheel does not fall: its axis goes round, nodding a little.":["[An einem Ende gehalten] f\xE4llt das Rad nicht: Seine Achse pr\xE4zediert und nickt ein wenig.","[Sujeta por un extremo], la rueda no cae: su eje precesa, cabeceando un poco.","[Tenue par un bout], la roue ne tombe pas\xA0: son axe pr\xE9cesse, en nutant un peu."],"[Let it spin at a tenth], and it nods deeply.":["[Bei einem Zehntel der Drehung] nickt es tief.","[H\xE1gala girar a la d\xE9cima parte], y cabecea mucho.","[Faites-la tourner dix fois moins vite], et elle nute fortement."],"The drum that [spins inside] holds L within 6.3\xB0 of its axis, the axis of least moment, where the body alone would not stay once it loses energy. The levels on the sphere move with the drum's speed.":["Die Trommel, die sich [im Innern dreht], h\xE4lt L innerhalb von 6,3\xB0 um ihre Achse, die Achse des kleinsten Tr\xE4gheitsmoments, wo der K\xF6rper allein nicht bliebe, sobald er Energie verliert. Die Niveaulinien auf der Kugel wandern mit der Drehzahl der Trommel.","El tambor que [gira en el interior] mantiene L a menos de 6,3\xB0 de su eje, el de menor momento, donde el cuerpo solo no se quedar\xEDa al perder energ\xEDa. Los niveles sobre la esfera se mueven con la velocidad del tambor.","Le tambour qui [tourne \xE0 l'int\xE9rieur] tient L \xE0 moins de 6,3\xB0 de son axe, l'axe de plus petit moment, o\xF9 le corps seul ne resterait pas d\xE8s qu'il perd de l'\xE9nergie. Les niveaux sur la sph\xE8re se d\xE9placent avec la vitesse du tambour."],"[Stop the rotor] by its own motor: L stays, and the whole satellite now turns with the drum, at 56 rpm and within 6.3\xB0 of its axis. That spin has the most energy for its L, and losses would end it.":["[Rotor anhalten], durch seinen eigenen Motor: L bleibt, und der ganze Satellit dreht sich nun mit der Trommel, mit 56 U/min und innerhalb von 6,3\xB0 um ihre Achse. Diese Drehung hat die meiste Energie bei ihrem L, und Verluste w\xFCrden sie beenden.","[Parar el rotor] con su propio motor: L se mantiene, y todo el sat\xE9lite gira ahora con el tambor, a 56 rpm y a menos de 6,3\xB0 de su eje. Ese giro tiene la m\xE1xima energ\xEDa para su L, y las p\xE9rdidas acabar\xEDan con \xE9l.","[Arr\xEAter le rotor] par son propre moteur : L reste, et tout le satellite tourne maintenant avec le tambour, \xE0 56 tr/min et \xE0 moins de 6,3\xB0 de son axe. Cette rotation a le plus d'\xE9nergie pour son L, et des pertes y mettraient fin."],"A slender satellite, [spun about its long axis]: whips of wire lose energy, L stays, and in the end it turns end over end. The losses are enlarged some 4000 times: here it takes 1.6 s, and the satellite took an orbit, 115 minutes.":["Ein schlanker Satellit, [um seine L\xE4ngsachse gedreht]: Drahtantennen verlieren Energie, L bleibt, und am Ende \xFCberschl\xE4gt er sich. Die Verluste sind etwa 4000-fach vergr\xF6\xDFert: Hier dauert es 1,6 s, beim Satelliten war es ein Umlauf, 115 Minuten.","Un sat\xE9lite esbelto, [girado alrededor de su eje largo]: las antenas de alambre pierden energ\xEDa, L se mantiene, y al final da vueltas de campana. Las p\xE9rdidas est\xE1n aumentadas unas 4000 veces: aqu\xED tarda 1,6 s, y el sat\xE9lite tard\xF3 una \xF3rbita, 115 minutos.","Un satellite \xE9lanc\xE9, [lanc\xE9 autour de son axe long] : des antennes en fil perdent de l'\xE9nergie, L reste, et \xE0 la fin il culbute. Les pertes sont agrandies environ 4000 fois : ici cela prend 1,6 s, et le satellite a mis une orbite, 115 minutes."],"[With a tenth of the losses] it takes ten times as long.":["[Mit einem Zehntel der Verluste] dauert es zehnmal so lange.","[Con una d\xE9cima parte de las p\xE9rdidas] tarda diez veces m\xE1s.","[Avec un dixi\xE8me des pertes] cela prend dix fois plus de temps."],"[Tilted by 12\xB0] its contact goes round 11 times a second. Rolling friction and air take its energy, and after 81 s it lies flat. The button under the picture lets you hear it.":["[Um 12\xB0 geneigt] l\xE4uft ihr Ber\xFChrpunkt 11-mal je Sekunde um. Rollreibung und Luft nehmen ihr die Energie, und nach 81 s liegt sie flach. Der Knopf unter dem Bild macht sie h\xF6rbar.","[Inclinado 12\xB0], su contacto da la vuelta 11 veces por segundo. La fricci\xF3n de rodadura y el aire le quitan energ\xEDa, y tras 81 s queda plano. El bot\xF3n bajo la imagen permite o\xEDrlo.","[Inclin\xE9 de 12\xB0], son contact fait le tour 11 fois par seconde. Le frottement de roulement et l'air prennent son \xE9nergie, et apr\xE8s 81 s il est \xE0 plat. Le bouton sous l'image le fait entendre."],"The lower it lies, the faster it rattles: [begun at 1\xB0], its contact goes round 38 times a second. Its face hardly seems to move, and it lies flat 0.54 s later.":["Je flacher sie liegt, desto schneller klappert sie: [Bei 1\xB0 begonnen] l\xE4uft ihr Ber\xFChrpunkt 38-mal je Sekunde um. Ihre Fl\xE4che scheint sich kaum zu bewegen, und 0,54 s sp\xE4ter liegt sie flach.","Cuanto m\xE1s bajo est\xE1, m\xE1s r\xE1pido repiquetea: [iniciado a 1\xB0], su contacto da la vuelta 38 veces por segundo. Su cara apenas parece moverse, y queda plano 0,54 s despu\xE9s.","Plus il est bas, plus il cr\xE9pite vite\xA0: [parti de 1\xB0], son contact fait le tour 38 fois par seconde. Sa face semble \xE0 peine bouger, et il est \xE0 plat 0,54 s plus tard."],"A racket with 20 quanta of spin: each curve [on the sphere] is one of its 41 levels. Press play: L is not sharp, so the cloud of classical bodies spreads while it turns over, and the quantum state makes waves where the cloud folds.":["Ein Schl\xE4ger mit 20 Drehimpulsquanten: Jede Kurve [auf der Kugel] ist eines seiner 41 Niveaus. Dr\xFCcken Sie auf Abspielen: L ist nicht scharf, darum zerl\xE4uft die Wolke klassischer K\xF6rper beim Umkippen, und der Quantenzustand macht Wellen, wo die Wolke sich faltet.","Una raqueta con 20 cuantos de momento angular: cada curva [sobre la esfera] es uno de sus 41 niveles. Pulse reproducir: L no est\xE1 bien definido, as\xED que la nube de cuerpos cl\xE1sicos se extiende al darse la vuelta, y el estado cu\xE1ntico hace ondas donde la nube se pliega.","Une raquette avec 20 quanta de moment cin\xE9tique\xA0: chaque courbe [sur la sph\xE8re] est l'un de ses 41 niveaux. Lancez la lecture\xA0: L n'est pas d\xE9fini exactement, donc le nuage de corps classiques s'\xE9tale en se retournant, et l'\xE9tat quantique fait des ondes l\xE0 o\xF9 le nuage se plie."],"[Stand it on the middle axis] itself: a classical body stays there for ever, the quantum one turns over all the same.":["[Genau auf der mittleren Achse]: Ein klassischer K\xF6rper bleibt dort f\xFCr immer, der quantenmechanische kippt trotzdem um.","[P\xF3ngala sobre el eje intermedio] mismo: un cuerpo cl\xE1sico se queda ah\xED para siempre, el cu\xE1ntico se da la vuelta igualmente.","[Placez-la sur l'axe interm\xE9diaire] m\xEAme\xA0: un corps classique y reste pour toujours, le quantique se retourne quand m\xEAme."],"[One level alone] does not move: its state lies along a polhode and its mirror image, with waves between them.":["[Ein einzelnes Niveau] bewegt sich nicht: Sein Zustand liegt entlang einer Polhodie und ihrem Spiegelbild, mit Wellen dazwischen.","[Un solo nivel] no se mueve: su estado sigue una polhodia y su imagen especular, con ondas entre ellas.","[Un seul niveau] ne bouge pas\xA0: son \xE9tat suit une polhodie et son image miroir, avec des ondes entre elles."]}};var Wx=["aria-label","title","alt"],qx=n=>document.getElementById(n),Zu=class{changed=()=>{};constructor(){Gg(Hx),this.places=t3(document.body),this.asked=null,this.select=qx("language"),this.select.append(...cr().map(e=>new Option(e3(e),e))),this.select.addEventListener("change",()=>{this.take(this.select.value),this.changed()})}take(e){this.asked=cr().includes(e)?e:null,Hg(this.asked??Vg(navigator.languages??[])),document.documentElement.lang=fu(),document.title=W(this.title??=document.title),this.select.value=fu(),qx("language-code").textContent=fu().toUpperCase();for(let t of this.places)t.put(W(t.english))}};function e3(n){try{let e=new Intl.DisplayNames([n],{type:"language"}).of(n);return e[0].toUpperCase()+e.slice(1)}catch{return n}}function t3(n){let e=[],t=document.createTreeWalker(n,NodeFilter.SHOW_TEXT);for(let i=t.nextNode();i;i=t.nextNode()){let s=i.data.trim();if(!Xx(s)||i.parentElement.closest("script, style, noscript"))continue;let r=i,[o,a]=i.data.split(s);e.push({english:s,put:l=>r.data=o+l+a})}for(let i of n.querySelectorAll(Wx.map(s=>`[${s}]`).join()))for(let s of Wx){let r=i.getAttribute(s);r&&Xx(r)&&e.push({english:r,put:o=>i.setAttribute(s,o)})}return e}var Xx=n=>/\p{L}{2}/u.test(n);var ju=class{constructor(e,t){this.root=e,this.changed=t,this.large=0}take(e){this.types=e,this.root.dataset.count=String(e.length),[...this.root.children].forEach((t,i)=>t.querySelector(".enlarge").addEventListener("click",()=>this.enlarge(i,!0))),this.large=0,this.mark()}get named(){return this.large?this.types[this.large]:null}enlarge(e,t=!1){let i=typeof e=="number"?e:this.types.indexOf(e);return i<0?!1:(this.large=i,this.mark(),t&&this.root.children[i].querySelector("canvas").focus({preventScroll:!0}),this.changed(),!0)}mark(){[...this.root.children].forEach((e,t)=>e.classList.toggle("large",t===this.large))}},Ku=class{constructor(e){this.elements=e,window.addEventListener("resize",()=>this.release())}keep(){for(let e of this.elements){let{height:t}=e.getBoundingClientRect();t>parseFloat(e.style.minHeight||0)&&(e.style.minHeight=`${t}px`)}}release(){for(let e of this.elements)e.style.minHeight=""}};var $x=new _n,Ju=new C,Vs=class extends fa{constructor(){super(),this.isLineSegmentsGeometry=!0,this.type="LineSegmentsGeometry";let e=[-1,2,0,1,2,0,-1,1,0,1,1,0,-1,0,0,1,0,0,-1,-1,0,1,-1,0],t=[-1,2,1,2,-1,1,1,1,-1,-1,1,-1,-1,-2,1,-2],i=[0,2,1,2,3,1,2,4,3,4,5,3,4,6,5,6,7,5];this.setIndex(i),this.setAttribute("position",new tt(e,3)),this.setAttribute("uv",new tt(t,2))}applyMatrix4(e){let t=this.attributes.instanceStart,i=this.attributes.instanceEnd;return t!==void 0&&(t.applyMatrix4(e),i.applyMatrix4(e),t.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}setPositions(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let i=new Es(t,6,1);return this.setAttribute("instanceStart",new ei(i,3,0)),this.setAttribute("instanceEnd",new ei(i,3,3)),this.instanceCount=this.attributes.instanceStart.count,this.computeBoundingBox(),this.computeBoundingSphere(),this}setColors(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let i=new Es(t,6,1);return this.setAttribute("instanceColorStart",new ei(i,3,0)),this.setAttribute("instanceColorEnd",new ei(i,3,3)),this}fromWireframeGeometry(e){return this.setPositions(e.attributes.position.array),this}fromEdgesGeometry(e){return this.setPositions(e.attributes.position.array),this}fromMesh(e){return this.fromWireframeGeometry(new sa(e.geometry)),this}fromLineSegments(e){let t=e.geometry;return this.setPositions(t.attributes.position.array),this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new _n);let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;e!==void 0&&t!==void 0&&(this.boundingBox.setFromBufferAttribute(e),$x.setFromBufferAttribute(t),this.boundingBox.union($x))}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Nn),this.boundingBox===null&&this.computeBoundingBox();let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;if(e!==void 0&&t!==void 0){let i=this.boundingSphere.center;this.boundingBox.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)Ju.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Ju)),Ju.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(Ju));this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error("THREE.LineSegmentsGeometry.computeBoundingSphere(): Computed radius is NaN. The instanced position data is likely to have NaN values.",this)}}toJSON(){}};fe.line={worldUnits:{value:1},linewidth:{value:1},resolution:{value:new Ge},dashOffset:{value:0},dashScale:{value:1},dashSize:{value:1},gapSize:{value:1}};bn.line={uniforms:wa.merge([fe.common,fe.fog,fe.line]),vertexShader:`
		#include <common>
		#include <color_pars_vertex>
		#include <fog_pars_vertex>
		#include <logdepthbuf_pars_vertex>
		#include <clipping_planes_pars_vertex>

		uniform float linewidth;
		uniform vec2 resolution;

		attribute vec3 instanceStart;
		attribute vec3 instanceEnd;

		attribute vec3 instanceColorStart;
		attribute vec3 instanceColorEnd;

		#ifdef WORLD_UNITS

			varying vec4 worldPos;
			varying vec3 worldStart;
			varying vec3 worldEnd;

			#ifdef USE_DASH

				varying vec2 vUv;

			#endif

		#else

			varying vec2 vUv;

		#endif

		#ifdef USE_DASH

			uniform float dashScale;
			attribute float instanceDistanceStart;
			attribute float instanceDistanceEnd;
			varying float vLineDistance;

		#endif

		float trimSegmentAlpha( const in vec4 start, const in vec4 end ) {

			// compute the interpolation factor needed to trim the segment so it terminates
			// between the camera plane and the near plane

			// conservative estimate of the near plane
			float a = projectionMatrix[ 2 ][ 2 ]; // 3nd entry in 3th column
			float b = projectionMatrix[ 3 ][ 2 ]; // 3nd entry in 4th column

			// we need different nearEstimate formula for reversed and default depth buffer
			// a is positive with a reversed depth buffer so it can be used for controlling the code flow
			float nearEstimate = ( a > 0.0 ) ? ( - b / ( a + 1.0 ) ) : ( - 0.5 * b / a );

			return ( nearEstimate - start.z ) / ( end.z - start.z );

		}

		void main() {

			#ifdef USE_COLOR

				vColor.xyz = ( position.y < 0.5 ) ? instanceColorStart : instanceColorEnd;

			#endif

			float aspect = resolution.x / resolution.y;

			// camera space
			vec4 start = modelViewMatrix * vec4( instanceStart, 1.0 );
			vec4 end = modelViewMatrix * vec4( instanceEnd, 1.0 );

			#ifdef USE_DASH

				float lineDistanceStart = dashScale * instanceDistanceStart;
				float lineDistanceEnd = dashScale * instanceDistanceEnd;

			#endif

			#ifdef WORLD_UNITS

				worldStart = start.xyz;
				worldEnd = end.xyz;

			#else

				vUv = uv;

			#endif

			// special case for perspective projection, and segments that terminate either in, or behind, the camera plane
			// clearly the gpu firmware has a way of addressing this issue when projecting into ndc space
			// but we need to perform ndc-space calculations in the shader, so we must address this issue directly
			// perhaps there is a more elegant solution -- WestLangley

			bool perspective = ( projectionMatrix[ 2 ][ 3 ] == - 1.0 ); // 4th entry in the 3rd column

			if ( perspective ) {

				if ( start.z < 0.0 && end.z >= 0.0 ) {

					float alpha = trimSegmentAlpha( start, end );
					end.xyz = mix( start.xyz, end.xyz, alpha );

					#ifdef USE_DASH

						lineDistanceEnd = mix( lineDistanceStart, lineDistanceEnd, alpha );

					#endif

				} else if ( end.z < 0.0 && start.z >= 0.0 ) {

					float alpha = trimSegmentAlpha( end, start );
					start.xyz = mix( end.xyz, start.xyz, alpha );

					#ifdef USE_DASH

						lineDistanceStart = mix( lineDistanceEnd, lineDistanceStart, alpha );

					#endif

				}

			}

			#ifdef USE_DASH

				vLineDistance = ( position.y < 0.5 ) ? lineDistanceStart : lineDistanceEnd;
				vUv = uv;

			#endif

			// clip space
			vec4 clipStart = projectionMatrix * start;
			vec4 clipEnd = projectionMatrix * end;

			// ndc space
			vec3 ndcStart = clipStart.xyz / clipStart.w;
			vec3 ndcEnd = clipEnd.xyz / clipEnd.w;

			// direction
			vec2 dir = ndcEnd.xy - ndcStart.xy;

			// account for clip-space aspect ratio
			dir.x *= aspect;
			dir = normalize( dir );

			#ifdef WORLD_UNITS

				vec3 worldDir = normalize( end.xyz - start.xyz );
				vec3 tmpFwd = perspective ? normalize( mix( start.xyz, end.xyz, 0.5 ) ) : vec3( 0.0, 0.0, - 1.0 );
				vec3 worldUp = normalize( cross( worldDir, tmpFwd ) );
				vec3 worldFwd = cross( worldDir, worldUp );
				worldPos = position.y < 0.5 ? start: end;

				// height offset
				float hw = linewidth * 0.5;
				worldPos.xyz += position.x < 0.0 ? hw * worldUp : - hw * worldUp;

				// don't extend the line if we're rendering dashes because we
				// won't be rendering the endcaps
				#ifndef USE_DASH

					// cap extension
					worldPos.xyz += position.y < 0.5 ? - hw * worldDir : hw * worldDir;

					// add width to the box
					worldPos.xyz += worldFwd * hw;

					// endcaps
					if ( position.y > 1.0 || position.y < 0.0 ) {

						worldPos.xyz -= worldFwd * 2.0 * hw;

					}

				#endif

				// project the worldpos
				vec4 clip = projectionMatrix * worldPos;

				// shift the depth of the projected points so the line
				// segments overlap neatly
				vec3 clipPose = ( position.y < 0.5 ) ? ndcStart : ndcEnd;

				// only shift the depth of vertices in front of the camera (#35137)
				if ( clip.w > 0.0 ) clip.z = clipPose.z * clip.w;

			#else

				vec2 offset = vec2( dir.y, - dir.x );
				// undo aspect ratio adjustment
				dir.x /= aspect;
				offset.x /= aspect;

				// sign flip
				if ( position.x < 0.0 ) offset *= - 1.0;

				// endcaps
				if ( position.y < 0.0 ) {

					offset += - dir;

				} else if ( position.y > 1.0 ) {

					offset += dir;

				}

				// adjust for linewidth
				offset *= linewidth;

				// adjust for clip-space to screen-space conversion // maybe resolution should be based on viewport ...
				offset /= resolution.y;

				// select end
				vec4 clip = ( position.y < 0.5 ) ? clipStart : clipEnd;

				// back to clip space
				offset *= clip.w;

				clip.xy += offset;

			#endif

			gl_Position = clip;

			vec4 mvPosition = ( position.y < 0.5 ) ? start : end; // this is an approximation

			#include <logdepthbuf_vertex>
			#include <clipping_planes_vertex>
			#include <fog_vertex>

		}
		`,fragmentShader:`
		uniform vec3 diffuse;
		uniform float opacity;
		uniform float linewidth;

		#ifdef USE_DASH

			uniform float dashOffset;
			uniform float dashSize;
			uniform float gapSize;

		#endif

		varying float vLineDistance;

		#ifdef WORLD_UNITS

			varying vec4 worldPos;
			varying vec3 worldStart;
			varying vec3 worldEnd;

			#ifdef USE_DASH

				varying vec2 vUv;

			#endif

		#else

			varying vec2 vUv;

		#endif

		#include <common>
		#include <color_pars_fragment>
		#include <fog_pars_fragment>
		#include <logdepthbuf_pars_fragment>
		#include <clipping_planes_pars_fragment>

		vec2 closestLineToLine(vec3 p1, vec3 p2, vec3 p3, vec3 p4) {

			float mua;
			float mub;

			vec3 p13 = p1 - p3;
			vec3 p43 = p4 - p3;

			vec3 p21 = p2 - p1;

			float d1343 = dot( p13, p43 );
			float d4321 = dot( p43, p21 );
			float d1321 = dot( p13, p21 );
			float d4343 = dot( p43, p43 );
			float d2121 = dot( p21, p21 );

			float denom = d2121 * d4343 - d4321 * d4321;

			float numer = d1343 * d4321 - d1321 * d4343;

			mua = numer / denom;
			mua = clamp( mua, 0.0, 1.0 );
			mub = ( d1343 + d4321 * ( mua ) ) / d4343;
			mub = clamp( mub, 0.0, 1.0 );

			return vec2( mua, mub );

		}

		void main() {

			float alpha = opacity;
			vec4 diffuseColor = vec4( diffuse, alpha );

			#include <clipping_planes_fragment>

			#ifdef USE_DASH

				if ( vUv.y < - 1.0 || vUv.y > 1.0 ) discard; // discard endcaps

				if ( mod( vLineDistance + dashOffset, dashSize + gapSize ) > dashSize ) discard; // todo - FIX

			#endif

			#ifdef WORLD_UNITS

				float len;

				if ( isOrthographic ) {

					// View rays are parallel to the z axis so the distance reduces to camera-space XY
					vec2 lineDir = worldEnd.xy - worldStart.xy;
					float t = clamp( dot( worldPos.xy - worldStart.xy, lineDir ) / dot( lineDir, lineDir ), 0.0, 1.0 );
					len = length( worldStart.xy + lineDir * t - worldPos.xy );

				} else {

					// Find the closest points on the view ray and the line segment
					vec3 rayEnd = normalize( worldPos.xyz ) * 1e5;
					vec3 lineDir = worldEnd - worldStart;
					vec2 params = closestLineToLine( worldStart, worldEnd, vec3( 0.0, 0.0, 0.0 ), rayEnd );

					vec3 p1 = worldStart + lineDir * params.x;
					vec3 p2 = rayEnd * params.y;
					vec3 delta = p1 - p2;
					len = length( delta );

				}

				float norm = len / linewidth;

				#ifndef USE_DASH

					#ifdef USE_ALPHA_TO_COVERAGE

						float dnorm = fwidth( norm );
						alpha = 1.0 - smoothstep( 0.5 - dnorm, 0.5 + dnorm, norm );

					#else

						if ( norm > 0.5 ) {

							discard;

						}

					#endif

				#endif

			#else

				#ifdef USE_ALPHA_TO_COVERAGE

					// artifacts appear on some hardware if a derivative is taken within a conditional
					float a = vUv.x;
					float b = ( vUv.y > 0.0 ) ? vUv.y - 1.0 : vUv.y + 1.0;
					float len2 = a * a + b * b;
					float dlen = fwidth( len2 );

					if ( abs( vUv.y ) > 1.0 ) {

						alpha = 1.0 - smoothstep( 1.0 - dlen, 1.0 + dlen, len2 );

					}

				#else

					if ( abs( vUv.y ) > 1.0 ) {

						float a = vUv.x;
						float b = ( vUv.y > 0.0 ) ? vUv.y - 1.0 : vUv.y + 1.0;
						float len2 = a * a + b * b;

						if ( len2 > 1.0 ) discard;

					}

				#endif

			#endif

			#include <logdepthbuf_fragment>
			#include <color_fragment>

			gl_FragColor = vec4( diffuseColor.rgb, alpha );

			#include <tonemapping_fragment>
			#include <colorspace_fragment>
			#include <fog_fragment>
			#include <premultiplied_alpha_fragment>

		}
		`};var Hs=class extends ni{constructor(e){super({type:"LineMaterial",uniforms:wa.clone(bn.line.uniforms),vertexShader:bn.line.vertexShader,fragmentShader:bn.line.fragmentShader,clipping:!0}),this.isLineMaterial=!0,this.setValues(e)}get color(){return this.uniforms.diffuse.value}set color(e){this.uniforms.diffuse.value=e}get worldUnits(){return"WORLD_UNITS"in this.defines}set worldUnits(e){e===!0!==this.worldUnits&&(this.needsUpdate=!0),e===!0?this.defines.WORLD_UNITS="":delete this.defines.WORLD_UNITS}get linewidth(){return this.uniforms.linewidth.value}set linewidth(e){this.uniforms.linewidth&&(this.uniforms.linewidth.value=e)}get dashed(){return"USE_DASH"in this.defines}set dashed(e){e===!0!==this.dashed&&(this.needsUpdate=!0),e===!0?this.defines.USE_DASH="":delete this.defines.USE_DASH}get dashScale(){return this.uniforms.dashScale.value}set dashScale(e){this.uniforms.dashScale.value=e}get dashSize(){return this.uniforms.dashSize.value}set dashSize(e){this.uniforms.dashSize.value=e}get dashOffset(){return this.uniforms.dashOffset.value}set dashOffset(e){this.uniforms.dashOffset.value=e}get gapSize(){return this.uniforms.gapSize.value}set gapSize(e){this.uniforms.gapSize.value=e}get opacity(){return this.uniforms.opacity.value}set opacity(e){this.uniforms&&(this.uniforms.opacity.value=e)}get resolution(){return this.uniforms.resolution.value}set resolution(e){this.uniforms.resolution.value.copy(e)}get alphaToCoverage(){return"USE_ALPHA_TO_COVERAGE"in this.defines}set alphaToCoverage(e){this.defines&&(e===!0!==this.alphaToCoverage&&(this.needsUpdate=!0),e===!0?this.defines.USE_ALPHA_TO_COVERAGE="":delete this.defines.USE_ALPHA_TO_COVERAGE)}};var Vf=new ot,Yx=new C,Zx=new C,rn=new ot,on=new ot,Fi=new ot,Hf=new C,Wf=new Qe,an=new pa,jx=new C,Qu=new _n,eh=new Nn,Oi=new ot,Bi,fr;function Kx(n,e,t){return Oi.set(0,0,-e,1).applyMatrix4(n.projectionMatrix),Oi.multiplyScalar(1/Oi.w),Oi.x=fr/t.width,Oi.y=fr/t.height,Oi.applyMatrix4(n.projectionMatrixInverse),Oi.multiplyScalar(1/Oi.w),Math.abs(Math.max(Oi.x,Oi.y))}function n3(n,e){let t=n.matrixWorld,i=n.geometry,s=i.attributes.instanceStart,r=i.attributes.instanceEnd,o=Math.min(i.instanceCount,s.count);for(let a=0,l=o;a<l;a++){an.start.fromBufferAttribute(s,a),an.end.fromBufferAttribute(r,a),an.applyMatrix4(t);let c=new C,u=new C;Bi.distanceSqToSegment(an.start,an.end,u,c),u.distanceTo(c)<fr*.5&&e.push({point:u,pointOnLine:c,distance:Bi.origin.distanceTo(u),object:n,face:null,faceIndex:a,uv:null,uv1:null})}}function i3(n,e,t){let i=e.projectionMatrix,r=n.material.resolution,o=n.matrixWorld,a=n.geometry,l=a.attributes.instanceStart,c=a.attributes.instanceEnd,u=Math.min(a.instanceCount,l.count),h=-e.near;Bi.at(1,Fi),Fi.w=1,Fi.applyMatrix4(e.matrixWorldInverse),Fi.applyMatrix4(i),Fi.multiplyScalar(1/Fi.w),Fi.x*=r.x/2,Fi.y*=r.y/2,Fi.z=0,Hf.copy(Fi),Wf.multiplyMatrices(e.matrixWorldInverse,o);for(let d=0,f=u;d<f;d++){if(rn.fromBufferAttribute(l,d),on.fromBufferAttribute(c,d),rn.w=1,on.w=1,rn.applyMatrix4(Wf),on.applyMatrix4(Wf),rn.z>h&&on.z>h)continue;if(rn.z>h){let v=rn.z-on.z,M=(rn.z-h)/v;rn.lerp(on,M)}else if(on.z>h){let v=on.z-rn.z,M=(on.z-h)/v;on.lerp(rn,M)}rn.applyMatrix4(i),on.applyMatrix4(i),rn.multiplyScalar(1/rn.w),on.multiplyScalar(1/on.w),rn.x*=r.x/2,rn.y*=r.y/2,on.x*=r.x/2,on.y*=r.y/2,an.start.copy(rn),an.start.z=0,an.end.copy(on),an.end.z=0;let x=an.closestPointToPointParameter(Hf,!0);an.at(x,jx);let m=iu.lerp(rn.z,on.z,x),g=m>=-1&&m<=1,y=Hf.distanceTo(jx)<fr*.5;if(g&&y){an.start.fromBufferAttribute(l,d),an.end.fromBufferAttribute(c,d),an.start.applyMatrix4(o),an.end.applyMatrix4(o);let v=new C,M=new C;Bi.distanceSqToSegment(an.start,an.end,M,v),t.push({point:M,pointOnLine:v,distance:Bi.origin.distanceTo(M),object:n,face:null,faceIndex:d,uv:null,uv1:null})}}}var _o=class extends Ye{constructor(e=new Vs,t=new Hs({color:Math.random()*16777215})){super(e,t),this.isLineSegments2=!0,this.type="LineSegments2"}computeLineDistances(){let e=this.geometry,t=e.attributes.instanceStart,i=e.attributes.instanceEnd,s=new Float32Array(2*t.count);for(let o=0,a=0,l=t.count;o<l;o++,a+=2)Yx.fromBufferAttribute(t,o),Zx.fromBufferAttribute(i,o),s[a]=a===0?0:s[a-1],s[a+1]=s[a]+Yx.distanceTo(Zx);let r=new Es(s,2,1);return e.setAttribute("instanceDistanceStart",new ei(r,1,0)),e.setAttribute("instanceDistanceEnd",new ei(r,1,1)),this}raycast(e,t){let i=this.material.worldUnits,s=e.camera;if(s===null&&!i&&console.error('LineSegments2: "Raycaster.camera" needs to be set in order to raycast against LineSegments2 while worldUnits is set to false.'),i===!1&&(this.material.resolution.x===0||this.material.resolution.y===0))return;let r=e.params.Line2!==void 0&&e.params.Line2.threshold||0;Bi=e.ray;let o=this.matrixWorld,a=this.geometry,l=this.material;fr=l.linewidth+r,a.boundingSphere===null&&a.computeBoundingSphere(),eh.copy(a.boundingSphere).applyMatrix4(o);let c;if(i)c=fr*.5;else{let h=Math.max(s.near,eh.distanceToPoint(Bi.origin));c=Kx(s,h,l.resolution)}if(eh.radius+=c,Bi.intersectsSphere(eh)===!1)return;a.boundingBox===null&&a.computeBoundingBox(),Qu.copy(a.boundingBox).applyMatrix4(o);let u;if(i)u=fr*.5;else{let h=Math.max(s.near,Qu.distanceToPoint(Bi.origin));u=Kx(s,h,l.resolution)}Qu.expandByScalar(u),Bi.intersectsBox(Qu)!==!1&&(i?n3(this,t):i3(this,s,t))}onBeforeRender(e){let t=this.material.uniforms;t&&t.resolution&&(e.getViewport(Vf),this.material.uniforms.resolution.value.set(Vf.z,Vf.w))}};var vo=class extends Vs{constructor(){super(),this.isLineGeometry=!0,this.type="LineGeometry"}setPositions(e){let t=e.length-3,i=new Float32Array(2*t);for(let s=0;s<t;s+=3)i[2*s]=e[s],i[2*s+1]=e[s+1],i[2*s+2]=e[s+2],i[2*s+3]=e[s+3],i[2*s+4]=e[s+4],i[2*s+5]=e[s+5];return super.setPositions(i),this}setColors(e){let t=e.length-3,i=new Float32Array(2*t);for(let s=0;s<t;s+=3)i[2*s]=e[s],i[2*s+1]=e[s+1],i[2*s+2]=e[s+2],i[2*s+3]=e[s+3],i[2*s+4]=e[s+4],i[2*s+5]=e[s+5];return super.setColors(i),this}setFromPoints(e){let t=e.length-1,i=new Float32Array(6*t);for(let s=0;s<t;s++)i[6*s]=e[s].x,i[6*s+1]=e[s].y,i[6*s+2]=e[s].z||0,i[6*s+3]=e[s+1].x,i[6*s+4]=e[s+1].y,i[6*s+5]=e[s+1].z||0;return super.setPositions(i),this}fromLine(e){let t=e.geometry;return this.setPositions(t.attributes.position.array),this}};var th=class extends _o{constructor(e=new vo,t=new Hs({color:Math.random()*16777215})){super(e,t),this.isLine2=!0,this.type="Line2"}};function Jx(n,e=Math.PI/3){let t=n.index?n.toNonIndexed():n,i=t.attributes.position,s=i.count,r;if(i.isBufferAttribute===!0&&i.itemSize===3&&i.normalized===!1)r=i.array;else{r=new Float64Array(s*3);for(let M=0;M<s;M++)r[3*M+0]=i.getX(M),r[3*M+1]=i.getY(M),r[3*M+2]=i.getZ(M)}let o=Math.cos(e),a=(1+1e-10)*100,l=s/3,c=new Float64Array(l*3);for(let M=0;M<l;M++){let w=9*M,E=r[w+0],_=r[w+1],b=r[w+2],I=r[w+3],T=r[w+4],L=r[w+5],D=r[w+6],B=r[w+7],P=r[w+8],O=D-I,H=B-T,V=P-L,ee=E-I,X=_-T,j=b-L,te=H*j-V*X,ve=V*ee-O*j,Pe=O*X-H*ee,Y=1/(Math.sqrt(te*te+ve*ve+Pe*Pe)||1);c[3*M+0]=te*Y,c[3*M+1]=ve*Y,c[3*M+2]=Pe*Y}let u=new Int32Array(s),h=new Float64Array(s*3),d=1;for(;d<s*2;)d<<=1;let f=d-1,p=new Int32Array(d),x=0;for(let M=0;M<s;M++){let w=3*M,E=Math.trunc(r[w+0]*a),_=Math.trunc(r[w+1]*a),b=Math.trunc(r[w+2]*a),I=(Math.imul(E,73856093)^Math.imul(_,19349663)^Math.imul(b,83492791))&f;for(;;){let T=p[I];if(T===0){let D=3*x;h[D+0]=E,h[D+1]=_,h[D+2]=b,p[I]=x+1,u[M]=x++;break}let L=3*(T-1);if(h[L+0]===E&&h[L+1]===_&&h[L+2]===b){u[M]=T-1;break}I=I+1&f}}let m=new Int32Array(x+1);for(let M=0;M<s;M++)m[u[M]+1]++;for(let M=0;M<x;M++)m[M+1]+=m[M];let g=new Int32Array(s),y=m.slice(0,x);for(let M=0;M<l;M++){let w=3*M;g[y[u[w+0]]++]=M,g[y[u[w+1]]++]=M,g[y[u[w+2]]++]=M}let v=new Float32Array(s*3);for(let M=0;M<l;M++){let w=3*M,E=c[w+0],_=c[w+1],b=c[w+2];for(let I=0;I<3;I++){let T=w+I,L=u[T],D=0,B=0,P=0;for(let H=m[L],V=m[L+1];H<V;H++){let ee=3*g[H],X=c[ee+0],j=c[ee+1],te=c[ee+2];E*X+_*j+b*te>o&&(D+=X,B+=j,P+=te)}let O=1/(Math.sqrt(D*D+B*B+P*P)||1);v[3*T+0]=D*O,v[3*T+1]=B*O,v[3*T+2]=P*O}}return t.setAttribute("normal",new Rt(v,3,!1)),t}var ey=new C(0,1,0),qf=.995,s3=.6,nh=2*Math.PI,ss=64,ty=(n,e,t)=>new Hs({color:new Fe(n),linewidth:e,transparent:t<1,opacity:t,alphaToCoverage:!1});function Kt(n,e,t,i=1){let s=new th(new vo,ty(e,t,i));return s.geometry.setPositions(n.length>3?n:[...n,...n]),s.frustumCulled=!1,s}var rs=(n,e,t=1)=>ny(new qr,n,e,t);function ny(n,e,t,i){return n.geometry.setAttribute("position",new Rt(Float32Array.from(e),3)),n.material=new Ms({color:t,transparent:i<1,opacity:i}),n.frustumCulled=!1,n}function Xf(n,e){n.geometry.instanceCount=Math.max(0,e),n.visible=e>0}function Mo(n,e,t,i=1){if(t<=1)return ny(new nr,n,e,i);let s=new _o(new Vs,ty(e,t,i));return s.geometry.setPositions(n),s.frustumCulled=!1,s}var os=(n,e,t,i)=>n.joined?Kt(e,t,i):pr(e,t,i);function as(n,e,t){n.joined?Xf(e,t):e.geometry.setDrawRange(0,t+1)}function pr(n,e,t){let i=new xt;i.setAttribute("position",new Rt(Float32Array.from(n),3));let s=new Jo(i,new Xr({color:e,size:t,sizeAttenuation:!1}));return s.frustumCulled=!1,s}function ki(n,e,t,i=1){let s=[];for(let r=0;r<=128;r++)s.push(n*Math.cos(nh*r/128),n*Math.sin(nh*r/128),e);return i>1?Kt(s,t,i):rs(s,t)}function mr(n,e){let t=new vn({color:n}),i=new Ye(new fi(e,e,1,16),t),s=new Ye(new bs(3*e,8*e,24),t),r=new ut().add(i,s);return r.point=(o,a)=>{let l=Math.max(a-8*e,1e-6);r.visible=a>.001,i.scale.set(1,l,1),i.position.set(0,.5*l,0),s.position.set(0,a-4*e,0),r.quaternion.copy(new rt().setFromUnitVectors(ey,o.clone().normalize())),r.userData.tip=o.clone().normalize().multiplyScalar(a)},r}function Ws(n,e,t){let i=new Ye(new zn(t,24,16),new dn({color:n})),s=new Ye(new zn(1.35*t,24,16),new dn({color:e,side:1}));return new ut().add(i,s)}function iy(n,e,t,i){let s=new Ye(new bs(.45*i,i,16),new dn({color:n}));return s.position.copy(e).multiplyScalar(1.003),s.quaternion.setFromUnitVectors(ey,t),s}var Qx={stable:()=>new zn(.045,20,14),unstable:()=>new na(.06),undecided:()=>new Ki(.075,.075,.075)};function sy(n,e,t,i){let s=new Ye(Qx[e](),new dn({color:t})),r=new Ye(Qx[e](),new dn({color:i,side:1}));r.scale.setScalar(1.3);let o=new ut().add(s,r);return o.position.copy(n),o}var Xa=null;function r3(){if(Xa)return Xa;let n=new Uint8Array(4*ss*ss);for(let e=0;e<ss;e++)for(let t=0;t<ss;t++){let[i,s]=[2*t/(ss-1)-1,2*e/(ss-1)-1],r=Math.exp(-12*((i+.35)**2+(s-.45)**2)),o=.62+.3*Math.tanh(2.5*s)-.3*Math.exp(-18*(s+.1)**2),a=Math.round(255*Math.min(1,Math.max(.12,o+.5*r)));n.set([a,a,a,255],4*(ss*e+t))}return Xa=new di(n,ss,ss),Xa.needsUpdate=!0,Xa}function ry(n,e,t,i,s=null,r=!1){let o=new xt;if(o.setAttribute("position",new Rt(Float32Array.from(n),3)),o.setIndex(new Rt(e,1)),s){let h=[...s].flatMap(d=>new Fe(d).toArray());o.setAttribute("color",new Rt(Float32Array.from(h),3))}let a=Jx(o,s3),l={color:s?"#ffffff":t,vertexColors:!!s,side:2,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1},c=r?new oa({...l,matcap:r3()}):new vn(l),u=new nr(new $r(o,30),new Ms({color:i,transparent:!0,opacity:.6}));return new ut().add(new Ye(a,c),u)}function oy(n,e,t){let i=new Ki(...n),s=new vn({color:e,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1}),r=new nr(new $r(i),new Ms({color:t,transparent:!0,opacity:.6}));return new ut().add(new Ye(i,s),r)}function $a(n,e,t,i=1){let s=new vn({color:e,transparent:i<1,opacity:i,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1}),r=new Ye(new zn(1,80,48),s);r.scale.set(...n);let o=new ut().add(r);for(let a=0;a<3;a++){let l=[];for(let c=0;c<=128;c++){let u=[0,0,0];u[(a+1)%3]=n[(a+1)%3]*Math.cos(nh*c/128),u[(a+2)%3]=n[(a+2)%3]*Math.sin(nh*c/128),l.push(...u)}o.add(rs(l,t,.7))}return o.userData.mesh=r,o}function ay(n,e,t){let i=new xt,s=new Float32Array(3*Math.max(0,n.length-3));for(let a=0;a+5<n.length;a+=3)s.set(n.slice(a,a+6),3*a+3);i.setAttribute("position",new Rt(s,3));let r=new dn({color:e,transparent:!0,opacity:t,side:2,depthWrite:!1}),o=new Ye(i,r);return o.frustumCulled=!1,o.renderOrder=2,o}function bo(n){let e=new vn({color:n.sphere,transparent:!0,opacity:.8,depthWrite:!0}),t=new Ye(new zn(qf,80,48),e);return t.renderOrder=1,t}function So(n,e,t,i=4){let s=new fi(n,n,1e-4,96);s.rotateX(Math.PI/2);let r=new dn({color:t.plane,transparent:!0,opacity:.75,polygonOffset:!0,polygonOffsetFactor:2,polygonOffsetUnits:2}),o=new Ye(s,r),a=new ut().add(o);for(let l=1;l<=i;l++)a.add(ki(n*l/i,0,t.ring));return a.position.set(0,0,e),a.userData.mesh=o,a}function ly(n){n.traverse(e=>{e.geometry?.dispose();for(let t of[e.material].flat())t?.dispose()})}var o3=17,a3=200,l3=2,ih=class{constructor(e){this.view=e,this.renderer=new au({antialias:!0,alpha:!0,powerPreference:"low-power"}),this.renderer.setClearColor(0,0),this.size=[0,0]}draw(e,t,i){let s=Math.min(window.devicePixelRatio||1,l3),r=t.map(l=>[l.clientWidth,l.clientHeight]);this.fit(r.reduce((l,[c])=>l+c,0),Math.max(...r.map(([,l])=>l)),s);let o=0,a=e.map((l,c)=>{let[u,h]=r[c];return u&&h&&this.render(l,o,u,h),o+=u,o-u});e.forEach((l,c)=>this.copy(l,t[c],a[c],r[c],s,i))}render(e,t,i,s){let{renderer:r}=this;e.flat?h3(e.camera,e.flat,i/s):this.view.place(e.camera,e.target??Kd,e.radius,i/s),e.lamp.position.copy(e.camera.position).add(d3.clone().applyQuaternion(e.camera.quaternion)),e.lamp.target.position.copy(e.target??Kd),e.lamp.target.updateMatrixWorld(),r.setViewport(t,0,i,s),r.setScissor(t,0,i,s),r.setScissorTest(!0),r.render(e.scene,e.camera)}copy(e,t,i,[s,r],o,a){let[l,c]=[Math.round(s*o),Math.round(r*o)];if(!l||!c)return;(t.width!==l||t.height!==c)&&([t.width,t.height]=[l,c]);let u=t.getContext("2d"),h=this.renderer.domElement;u.clearRect(0,0,l,c),u.drawImage(h,i*o,h.height-c,l,c,0,0,l,c),this.write(e,u,l,c,o,a)}fit(e,t,i){let s=[Math.max(this.size[0],e),Math.max(this.size[1],t)];this.dots===i&&s[0]===this.size[0]&&s[1]===this.size[1]||([this.size,this.dots]=[s,i],this.renderer.setPixelRatio(i),this.renderer.setSize(...s,!1))}write(e,t,i,s,r,o){if(e.boxes=[],Math.min(i,s)<a3*r)return;t.font=`600 ${13*r}px system-ui, sans-serif`,t.textAlign="center",t.textBaseline="middle",t.lineJoin="round";let a=[];for(let{text:l,place:c,color:u}of e.labels()){let h=W(l),d=c.clone().project(e.camera),f=[t.measureText(h).width+4*r,o3*r],p=[.5*(1+d.x)*i,.5*(1-d.y)*s],x=u3(p,f,a,[i,s]);a.push(x);let[m,g]=[x[0]+.5*f[0],x[1]+.5*f[1]];t.lineWidth=4*r,t.strokeStyle=o.ground,t.strokeText(h,m,g),t.fillStyle=u,t.fillText(h,m,g)}e.boxes=a.map(l=>l.map(c=>c/r))}},cy=[[0,0],[1,0],[-1,0],[0,-1],[0,1],[1,-1],[-1,-1],[1,1],[-1,1]],c3=4;function u3([n,e],[t,i],s,[r,o]){let a=(u,h,d)=>Math.min(Math.max(u,0),Math.max(0,d-h)),l=([u,h])=>s.every(([d,f,p,x])=>u>=d+p||d>=u+t||h>=f+x||f>=h+i),c=null;for(let u=0;u<=c3;u++)for(let[h,d]of u?cy.slice(1):cy.slice(0,1)){let f=a(n-.5*t+u*h*.55*t,t,r),p=a(e-.5*i+u*d*.55*i,i,o);if(c??=[f,p],l([f,p]))return[f,p,t,i]}return[...c,t,i]}function h3(n,{wide:e,high:t,x:i=0},s){let r=Math.max(t,e/s)/Math.tan(du*Math.PI/360);n.position.set(i,0,r),n.up.set(0,1,0),n.aspect=s,n.near=r/2,n.far=2*r,n.lookAt(i,0,0),n.updateProjectionMatrix(),n.updateMatrixWorld()}var d3=new C(-2,3,1);function qn(n,e){let t=new $o,i=new ha(16777215,2.1*n.lamp);return t.add(new da(16777215,1.3*n.lamp),i,i.target),{scene:t,lamp:i,camera:zg(),radius:1.5,labels:()=>[],probe:()=>({}),...e}}function uy(n,e,t){let i=e.center?"from the pivot towards the centre of mass":"third principal axis",s=qn(t,{title:"Path of the axis",words:i,radius:1.4,target:new C(0,0,.12)}),{scene:r}=s,o=new C(...e.axis),a=n.solver?.nutationLimits??null,l=a?a.filter(p=>p!==null&&Math.abs(p)<1):e.limits;r.add(bo(t),ki(1,0,t.family));for(let p of l)r.add(ki(Math.sqrt(Math.max(0,1-p*p)),p,t.border,1.5));let c=new Float64Array(3*n.count);for(let p=0;p<n.count;p++)o.clone().applyQuaternion(n.attitude(p)).toArray(c,3*p);let u=os(n,c,t.motion,2.6),h=n.joined?rs(c,t.motion,.35):null,d=Ws(t.motion,t.ground,.035),f=mr(t.momentum,.012);return f.position.set(0,0,1),f.point(new C(0,0,1),.32),r.add(u,d,f),h&&r.add(h),s.legend=[{color:t.motion,text:"axis"},...l.length?[{color:t.border,text:"limits of its tilt"}]:[]],s.update=p=>{d.position.copy(o).applyQuaternion(p.attitude),as(n,u,Math.floor(p.position))},s.labels=()=>[{text:"up",color:t.momentum,place:new C(0,0,1.42)}],s.probe=()=>({point:d.position.toArray(),path:[...c],limits:l}),s}var[hy,f3,p3]=[.45,.14,1.2],$f=6,m3=.45,dy=new C(0,1,0);function fy(n,e,t){let i=new C(...n.solver?.axis||e.axis).normalize(),s=new ut;for(let d=0;d<$f;d++){let f=new fi(hy,hy,f3,12,1,!1,2*Math.PI*d/$f,2*Math.PI/$f),p=new vn({color:t.rotor});d%2&&p.color.multiplyScalar(m3),s.add(new Ye(f,p))}let r=new rt().setFromUnitVectors(dy,i),o=i.clone().multiplyScalar(p3).toArray(),a=new ut().add(s,Kt([...o.map(d=>-d),...o],t.rotor,2)),l=g3(n,e),c=l&&x3(n.times,l),u=(d,{position:f})=>{let p=Math.min(Math.floor(f),d.length-2);return p<0?d[0]:d[p]+(f-p)*(d[p+1]-d[p])};return{object:a,turn:d=>{let f=c?u(c,d):0;s.quaternion.copy(r).multiply(new rt().setFromAxisAngle(dy,f))},rate:d=>l?u(l,d):null}}function g3(n,e){let t=n.solver;if(!t?.rotorRate)return ht(e.rates);if(t.rotorMoment===null)return null;let i=s=>[0,1,2].map(r=>n.velocities[3*s+r]);return Float64Array.from({length:n.count},(s,r)=>t.rotorRate(i(r))??0)}function x3(n,e){let t=new Float64Array(e.length);for(let i=1;i<e.length;i++)t[i]=t[i-1]+.5*(e[i]+e[i-1])*(n[i]-n[i-1]);return t}var y3=.035;function py({cage:{radius:n,center:e}},t){let i=new ut,s=new ra({color:t.edge,specular:"#ffffff",shininess:60}),r=()=>new Ye(new ia(n,y3*n,12,96),s),[o,a]=[r(),r()];o.rotation.y=Math.PI/2;for(let c of[o,a])c.position.z=e;return i.add(o,a),{object:i,turn:c=>{let u=c.clone().normalize(),h=new C(0,0,1).cross(u),d=h.lengthSq()>1e-12?h.normalize():new C(0,1,0);i.quaternion.setFromRotationMatrix(new Qe().makeBasis(d,u.clone().cross(d),u)),i.updateMatrix()}}}var my=2*Math.PI,gy=1200,_3=.35,v3=.02,M3=Math.PI/4;function xy(n,e,t,i=.22){let s=b3(n,e),r=[];for(let l=0;l<s.length;l+=3)r.push(new C().fromArray(s,l).angleTo(e));let[o,a]=[Math.min(...r),Math.max(...r)];return!(a>v3)||s.length<9?null:{object:new ut().add(ay(s,t,i),Kt(s,t,1.5)),halves:[o,a]}}function b3(n,e){let i=(Math.abs(e.z)<.9?new C(0,0,1):new C(1,0,0)).clone().cross(e).normalize(),s=e.clone().cross(i),r=[],[o,a]=[0,null],l=Math.max(1,Math.floor(n.length/3/(20*gy)));for(let d=0;d<n.length&&Math.abs(o)<my;d+=3*l){let f=new C().fromArray(n,d),p=Math.atan2(f.dot(s),f.dot(i));a!==null&&(o+=Math.atan2(Math.sin(p-a),Math.cos(p-a))),a=p,r.push(...f.toArray())}let c=S3(r,Math.ceil(r.length/3/gy)),u=new C().fromArray(c,0).distanceTo(new C().fromArray(c,c.length-3)),h=w3(c);return Math.abs(o)>=my-1e-9&&u<Math.max(_3,2)*h&&c.push(...c.slice(0,3)),c}function S3(n,e){if(e<=1)return n;let t=[];for(let i=0;i<n.length;i+=3*e)t.push(...n.slice(i,i+3));return t}function w3(n){let e=0;for(let t=3;t<n.length;t+=3)e+=Math.hypot(...[0,1,2].map(i=>n[t+i]-n[t-3+i]));return e/Math.max(1,n.length/3-1)}function Yf(n,e){if(!n.free||!n.momenta)return!1;for(let t=0;t<n.count;t++){let i=new C().fromArray(n.momenta,3*t);if(!(Math.atan2(i.clone().cross(e).length(),Math.abs(i.dot(e)))<M3))return!1}return!0}function yy(n,e,t){let i={space:[],body:[],axis:[]};for(let s=0;s<n.count;s++){let r=n.attitude(s);if(i.axis.push(...t.clone().applyQuaternion(r).applyQuaternion(n.space).toArray()),!n.velocities)continue;let o=new C().fromArray(n.velocities,3*s).multiplyScalar(e);i.body.push(...o.toArray()),i.space.push(...o.applyQuaternion(r).applyQuaternion(n.space).toArray())}return i}var Zf=1.36,[A3,E3]=[.6,.85],_y=new C(0,0,-1);function My(n,e,t){let i=T3(n.momenta),s=[],r=(c,u,h,d,f,p=1.1)=>s.push({entry:io(c,h,u),text:c,arrow:mr(h,d),lengthOf:f,label:p,from:null});if(n.momenta&&r("L","L",t.momentum,.02,c=>vy(n,c.momentum,c,Zf/i),1.08),n.velocities&&r("\u03A9","\u03A9",t.velocity,.017,c=>vy(n,c.velocity,c,Zf/n.fastest),1.16),e){let c=new C(...e),u=d=>c.clone().applyQuaternion(d.attitude).applyQuaternion(n.space),h=c.length();r("mg","weight mg",t.weight,.017,()=>_y.clone().multiplyScalar(A3)),s.at(-1).from=u,r("\u03C4","torque of the weight, dL/dt",t.torque,.017,d=>u(d).cross(_y).multiplyScalar(E3/h))}let o=c=>{for(let u of s){let h=u.lengthOf(c),d=Is(u.entry)&&Number.isFinite(h.lengthSq())?h.length():0;d>0?u.arrow.point(h,d):u.arrow.visible=!1,u.from&&u.arrow.position.copy(u.from(c))}},a=()=>s.filter(c=>c.arrow.visible).map(c=>({text:c.text,color:c.entry.color,place:c.arrow.userData.tip.clone().multiplyScalar(c.label).add(c.arrow.position)})),l=()=>Object.fromEntries(s.map(c=>[c.text,c.arrow.visible?{tip:c.arrow.userData.tip.toArray(),from:c.arrow.position.toArray()}:null]));return{objects:s.map(c=>c.arrow),entries:s.map(c=>c.entry),show:o,labels:a,probe:l}}var vy=(n,e,t,i)=>e.clone().applyQuaternion(t.attitude).applyQuaternion(n.space).multiplyScalar(Number.isFinite(i)?i:0),by=n=>n.fastest?Zf/n.fastest:0;function T3(n){let e=0;for(let t=0;n&&t<n.length;t+=3)e=Math.max(e,Math.hypot(n[t],n[t+1],n[t+2]));return e}var qs=1.22,R3={ground:0,post:-qs,hook:qs},C3=.4,I3=.35,P3=.06;function Sy(n,e,t){let i=e.pivot&&n.solver?{...e,pivot:F3(n,e.pivot)}:e,s=qn(t,{title:"The body in space",words:i.changed?"box or ellipsoid of the same inertia":i.shape,radius:i.pivot==="ground"?1.5:1.62});i.pivot||(s.target=new C(0,0,.08)),i.pivot==="ground"&&(s.target=new C(0,0,.42));let r=new ut;r.quaternion.copy(n.space),s.scene.add(r);let o=O3(n,i,t);r.add(o);let a=i.rotor?fy(n,i.rotor,t):null;a&&(L3(o),o.add(a.object));let l=[0,1,2].map(g=>{let y=new C().setComponent(g,qs);return o.add(Kt([0,0,0,...y.toArray()],t.axes[g],g===i.traced&&!i.along?2.5:1.5)),y}),c=t.axes[i.traced],h=(i.along?new C(...i.along):new C().setComponent(i.traced,1)).multiplyScalar(qs);i.along&&o.add(Kt([0,0,0,...h.toArray()],c,2.5));let d=z3(n,h,c);r.add(d.object),i.pivot?s.scene.add(So(i.pivot==="ground"?qs:.7,R3[i.pivot],t)):s.scene.add(ki(qs,0,t.ring)),i.pivot==="post"&&s.scene.add(Kt([0,0,-qs,0,0,0],t.edge,5)),i.pivot==="hook"&&s.scene.add(Kt([0,0,0,0,0,qs],t.edge,5));let f=My(n,i.weight?N3(i,h):null,t),p=D3(n,h,i,c,t),x=i.cage&&!i.changed?py(i,t):null;x&&s.scene.add(x.object);for(let g of f.objects)s.scene.add(g);for(let g of p)(g.inBody?o:s.scene).add(g.object);let m=null;return s.legend=[{color:c,text:i.along?"trace of the axis through the centre of mass":W("trace of axis {axis}",{axis:i.axes?.[i.traced]??i.traced+1})},...f.entries,...p.map(({entry:g})=>g),...a?[{color:t.rotor,text:U3(a.rate({position:0}))}]:[]],s.update=g=>{m=g,o.quaternion.copy(g.attitude),d.show(g.position),a?.turn(g),f.show(g),x?.turn(h.clone().applyQuaternion(g.attitude).applyQuaternion(n.space));for(let y of p)y.object.visible=Is(y.entry)},s.labels=()=>[...l.map((g,y)=>({text:i.axes?.[y]??`${y+1}`,color:t.axes[y],place:g.clone().multiplyScalar(1.07).applyQuaternion(m.attitude).applyQuaternion(n.space)})),...f.labels()],s.probe=()=>(o.updateWorldMatrix(!0,!1),{matrix:[...o.matrixWorld.elements],axisTip:h.clone().applyMatrix4(o.matrixWorld).toArray(),trace:[...d.points].slice(0,3*(d.shown+1)),momentumTip:f.probe().L?.tip??null,vectors:f.probe(),cage:x?x.object.matrix.elements.slice():null,cones:Object.fromEntries(p.map(({entry:g,halves:y,object:v})=>[g.key,{halves:y,shown:v.visible}])),rotor:a?[...a.object.children[0].quaternion.toArray(),a.rate(m)]:null}),s}function L3(n){n.traverse(e=>{e.isMesh&&(Object.assign(e.material,{transparent:!0,opacity:I3,depthWrite:!1}),e.renderOrder=1)})}var N3=({weight:n},e)=>e.clone().normalize().multiplyScalar(n.center).toArray();function D3(n,e,t,i,s){if(!n.joined||!n.attitudes||n.count<3)return[];let o=[0,1,2].map(h=>new C().setComponent(h,1)).find(h=>Yf(n,h))??null,a=Yf(n,e.clone().normalize()),l=yy(n,by(n),e),c=new C(0,0,1),u=o??e.clone().normalize();return l.body.length&&new C().fromArray(l.body).dot(u)<0&&u.negate(),[{key:"space cone",text:t.pivot?"cone of \u03A9 in space":"cone of \u03A9 about L (space cone)",rays:l.space,about:c,tint:s.herpolhode},{key:"body cone",text:"cone of \u03A9 in the body",rays:l.body,about:u,tint:s.bodyCone,inBody:!0},{key:"axis cone",text:"cone of the axis",rays:l.axis,about:c,tint:i}].flatMap(({key:h,text:d,rays:f,about:p,tint:x,inBody:m=!1})=>{let g=xy(f,p,x);return g?[{...g,inBody:m,entry:io(h,x,d,h==="axis cone"?a:o!==null)}]:[]})}function U3(n){return n===null?"rotor, drawn at rest: its moment is not given":W("rotor, {rate} against the body",{rate:xi(n)})}function F3(n,e){let t=[];for(let i=0;i<n.count;i++)t.push(new C(0,0,1).applyQuaternion(n.attitude(i)).z);return t.reduce((i,s)=>i+s,0)<0?"hook":e!=="ground"||Math.min(...t)<C3?"post":"ground"}function O3(n,e,t){let i=new ut,s=e.changed&&n.free?k3(n.free):null;if(s&&e.round)return i.add($a(s.map(r=>.5*r),t.body,t.edge));if(e.changed&&!s&&n.moments&&(e={ellipsoid:n.moments.map(r=>1/Math.sqrt(r))}),s)return i.add(oy(s,t.body,t.edge));if(e.surface){let r=ht(e.surface.vertices),o=B3(r),{faces:a,colors:l,shiny:c=!1,lines:u=[]}=e.surface;i.add(ry(r.map(h=>h/o),ht(a),t.body,t.edge,ht(l),c));for(let{points:h,color:d,width:f}of u){let p=[...ht(h)].map(m=>m/o),x=`#${d.toString(16).padStart(6,"0")}`;i.add(f>1?Kt(p,x,f):rs(p,x))}}else if(e.ellipsoid){let r=Math.max(...e.ellipsoid);i.add($a(e.ellipsoid.map(o=>o/r),t.body,t.edge))}return i}function B3(n){let e=0;for(let t=0;t<n.length;t+=3)e=Math.max(e,Math.hypot(n[t],n[t+1],n[t+2]));return e}function k3([n,e,t]){let i=[e+t-n,t+n-e,n+e-t],s=n+e+t;return i.some(r=>r<1e-9*s)?null:i.map(r=>2*Math.sqrt(r/s))}function z3(n,e,t){let i=[],s=[],r=l=>i.push(...e.clone().applyQuaternion(l).toArray()),o=null;for(let l=0;l<n.count;l++){let c=n.attitude(l);if(o&&n.joined){let u=Math.min(20,Math.ceil(o.angleTo(c)/P3));for(let h=1;h<u;h++)r(n.at(l-1+h/u).attitude)}r(c),s.push(i.length/3-1),o=c}let a={points:i,shown:0};return n.joined?(a.object=Kt(i,t,2),a.show=l=>Xf(a.object,a.shown=s[Math.floor(l)])):(a.object=pr(i,t,3),a.show=l=>a.object.geometry.setDrawRange(0,(a.shown=Math.floor(l))+1)),a}function wy(n,e,t){let i=n.at(0).momentum,{free:s}=n;if(!(i.length()>0))return qn(t,{title:"Poinsot's ellipsoid",words:"at rest",update:()=>{},legend:[]});let r=.5*i.toArray().reduce((T,L,D)=>T+L*L/s[D],0),o=s.map(T=>1/Math.sqrt(T)),a=1/Math.max(...o),l={moments:s,energy:r},c=a*Math.sqrt(2*r)/i.length(),u=V3(n,l,a),h=Math.max(1.25*G3(u,c),.9),d=1.3,f=.5*(d-c),p=qn(t,{title:"Poinsot's ellipsoid",words:"rolls without slipping on the plane across L",radius:Math.hypot(Math.max(h,1),d-f)*1.04,target:new C(0,0,f)}),x=new ut;x.quaternion.copy(n.space);let m=$a(o.map(T=>T*a),t.body,t.edge,.82);x.add(m);let g=So(h,-c,t);p.scene.add(x,g);let y=H3(n,u),v=os(n,u,t.motion,3),M=os(n,y,t.herpolhode,2.5);m.add(v),x.add(M),n.joined&&x.add(rs(y,t.herpolhode,.45));let w=Ws(t.velocity,t.ground,.03),E=mr(t.velocity,.012),_=mr(t.momentum,.012),b=rs([0,0,-c,0,0,0],t.edge);x.add(w,E),p.scene.add(_,b),_.point(new C(0,0,1),d);let I=0;return p.legend=[{color:t.motion,text:"polhode"},{color:t.herpolhode,text:"herpolhode"},{color:t.velocity,text:"contact, \u2212\u03A9"}],p.update=T=>{let L=Math.floor(T.position*n.fine);m.quaternion.copy(T.attitude),w.position.copy(Ay(T.momentum,l,a)).applyQuaternion(T.attitude),E.point(w.position,w.position.length()),as(n,v,L),as(n,M,L),I=L},p.labels=()=>[{text:"L",color:t.momentum,place:new C(0,0,d+.12)}],p.probe=()=>{for(let T of[m,g,w])T.updateWorldMatrix(!0,!0);return{ellipsoid:[...m.userData.mesh.matrixWorld.elements],plane:[...g.matrixWorld.elements],contact:new C().setFromMatrixPosition(w.matrixWorld).toArray(),bodyMatrix:[...m.matrixWorld.elements],spaceMatrix:[...x.matrixWorld.elements],polhode:[...u],herpolhode:[...y],shown:I/n.fine}},p}function Ay(n,{moments:e,energy:t},i){let s=-i/Math.sqrt(2*t);return new C(...n.toArray().map((r,o)=>s*r/e[o]))}function G3(n,e){let t=0;for(let i=0;i<n.length;i+=3)t=Math.max(t,Math.hypot(n[i],n[i+1],n[i+2]));return Math.sqrt(Math.max(0,t*t-e*e))}function V3(n,e,t){let i=new Float64Array(3*n.states.length);return n.states.forEach(({momentum:s},r)=>Ay(s,e,t).toArray(i,3*r)),i}function H3(n,e){let t=new Float64Array(e.length);return n.states.forEach(({attitude:i},s)=>{new C().fromArray(e,3*s).applyQuaternion(i).toArray(t,3*s)}),t}var W3=.45,[sh,Xs]=[72,144],jf=1.32,q3=1.05,X3=2*Math.PI;function Ey(n,e,t){let i=n.free??(n.solver?.mgl===void 0?n.solver?.moments:null);if(!i||e.families||!(n.at(0).momentum.length()>0))return null;let s=n.solver?.rotor??[0,0,0];if(Math.max(...i)<q3*Math.min(...i)&&!s.some(Boolean))return null;let r=new vn({color:t.energy,transparent:!0,opacity:W3,side:2,depthWrite:!1}),o=new Ye(Y3(),r);o.renderOrder=2,o.frustumCulled=!1;let a=io("energy",t.energy,"ellipsoid of the same energy",!1),l=null;return{object:o,entry:a,show:u=>{if(o.visible=Is(a)&&u.momentum.length()>0,!o.visible)return!1;let h=$3(i,s,u.momentum);return String([h.axes,h.center])!==String(l&&[l.axes,l.center])&&Z3(o.geometry,h),l=h,!0},probe:()=>({...l,shown:o.visible,corners:[...o.geometry.attributes.position.array]})}}function $3(n,e,t){let i=t.length(),s=t.toArray().reduce((r,o,a)=>r+(o-e[a])**2/n[a],0);return{axes:n.map(r=>Math.sqrt(s*r)/i),center:e.map(r=>r/i)}}function Y3(){let n=new xt;for(let e of["position","normal"])n.setAttribute(e,new Rt(new Float32Array(3*(sh+1)*(Xs+1)),3));return n}function Z3(n,{axes:e,center:t}){let{position:i,normal:s}=n.attributes,r=!t.some(Boolean),o=[];for(let l=0;l<=sh;l++)for(let c=0;c<=Xs;c++){let[u,h]=[Math.PI*l/sh,X3*c/Xs],d=[Math.sin(u)*Math.cos(h),Math.sin(u)*Math.sin(h),Math.cos(u)],f=r?1/Math.hypot(...d.map((y,v)=>y/e[v])):0,p=d.map((y,v)=>r?Math.min(f,jf)*y:t[v]+e[v]*y),x=p.map((y,v)=>(y-t[v])/e[v]**2),m=Math.hypot(...x)||1,g=l*(Xs+1)+c;i.setXYZ(g,...p.map(y=>qf*y)),s.setXYZ(g,...x.map(y=>y/m)),o.push(r?f<=jf:Math.hypot(...p)<=jf)}let a=[];for(let l=0;l<sh;l++)for(let c=0;c<Xs;c++){let u=l*(Xs+1)+c,[h,d,f]=[u+1,u+Xs+2,u+Xs+1];[u,h,d,f][r?"some":"every"](p=>o[p])&&a.push(u,f,d,u,d,h)}n.setIndex(a),i.needsUpdate=!0,s.needsUpdate=!0}var j3=18,K3=1.012,Ty=4,Ry={stable:"stable",unstable:"border",undecided:"undecided"},[J3,Q3]=[.8,.55],eI={stable:"stable",unstable:"unstable",undecided:"undecided"};function Cy(n,e,t){let i=qn(t,{title:e.title,words:e.words,radius:1.36}),{scene:s}=i,r=e.families?t.text:t.motion,o=bo(t);s.add(o);let a=n.free?n.at(0).momentum.toArray():null,[l,c]=a?[e.families?[]:m0(n.free),g0(n.free)]:e.changed&&n.solver?[x0(n.moments,n.solver.rotor??[0,0,0],n.at(0).momentum.length()),[]]:[ht(e.family)??[],ht(e.separatrix)??[]];l.length&&s.add(Mo(l,t.family,1));for(let{starts:v,axis:M}of e.families??[])s.add(Mo(v.flatMap(w=>Ua(n.free,w)),t.axes[M],1,.75));c.length&&s.add(Mo(c,t.border,1.8));let u=a&&Math.hypot(...a)>0?ur(n.free,a):null,h=u??tI(n),d=u?Kt(u,r,3.2):os(n,h,r,2);if(s.add(d),u)for(let v of nI(n.free,u,r))s.add(v);let f=e.changed?null:e.measured;f&&s.add(pr(f.map(v=>K3*v),t.velocity,6));let p=Ws(r,t.ground,.035);s.add(p);let x=[0,1,2].map(v=>{let M=new C().setComponent(v,1.2);return s.add(Kt([...new C().setComponent(v,1).toArray(),...M.toArray()],t.axes[v],2.5)),M}),m=n.free?p0(n.free):e.equilibria??[];for(let{at:v,verdict:M}of m)s.add(sy(new C(...v),M,t[Ry[M]],t.ground));let g=Ey(n,e,t);g&&s.add(g.object);let y=[...new Set(m.map(({verdict:v})=>v))];return i.legend=[{color:r,text:"this motion"},...f?[{color:t.velocity,text:"measured"}]:[],...c.length?[{color:t.border,text:"separatrix"}]:[],...l.length?[{color:t.family,text:e.legend}]:[],...(e.families??[]).map(({axis:v,legend:M})=>({color:t.axes[v],text:M})),...y.map(v=>({color:t[Ry[v]],text:eI[v]})),...g?[g.entry]:[]],i.update=v=>{let M=v.momentum.length();p.visible=M>0,M>0&&p.position.copy(v.momentum).divideScalar(M),u||as(n,d,Math.floor(v.position*n.fine)),o.material.opacity=g?.show(v)?Q3:J3},i.labels=()=>x.map((v,M)=>({text:e.axes?.[M]??`L${"\u2081\u2082\u2083"[M]}`,color:t.axes[M],place:v.clone().multiplyScalar(1.08)})),i.grasp=([v,M],w)=>{let E=p.position.clone().project(i.camera),_=p.position.dot(i.camera.position)>1;return n.free&&_&&Math.hypot(E.x-v,E.y-M)*.5*w<j3},i.under=v=>iI(v,i.camera),i.probe=()=>({point:p.position.toArray(),path:[...h],closed:!!u,measured:f,surface:g?.probe()??null,seen:p.position.clone().project(i.camera).toArray()}),i}function tI(n){let e=new Float64Array(3*n.states.length);return n.states.forEach(({momentum:t},i)=>t.clone().normalize().toArray(e,3*i)),e}function nI(n,e,t){let i=[],s=e.length/3-1;for(let r=0;r<Ty;r++){let o=new C().fromArray(e,3*Math.round((r+.5)/Ty*s)),a=o.clone().cross(new C(...o.toArray().map((l,c)=>l/n[c])));a.length()>0&&i.push(iy(t,o,a.normalize(),.085))}return i}function iI([n,e],t){let i=t.position.clone(),s=new C(n,e,.5).unproject(t).sub(i).normalize(),r=-i.dot(s),o=i.clone().addScaledVector(s,r),a=o.lengthSq();return a>=1?o.lengthSq()>0?o.normalize().toArray():null:i.addScaledVector(s,r-Math.sqrt(1-a)).normalize().toArray()}var Kf={palette:["#0072B2","#E69F00","#009E73","#D55E00","#56B4E9","#CC79A7"],light:{ground:"#ffffff",text:"#222222",motion:"#0072B2",border:"#D55E00",stable:"#009E73",undecided:"#6f6f6f",family:"#6f6f6f",velocity:"#a8477c",momentum:"#222222",weight:"#6f6f6f",torque:"#6b4fc8",herpolhode:"#a8477c",bodyCone:"#56B4E9",energy:"#d9b800",rotor:"#8c5a2b",ensemble:"#E69F00",classical:"#6f6f6f",axes:["#0072B2","#c78500","#009E73"],sphere:"#eef1f4",body:"#b9c6d3",edge:"#5a6672",plane:"#dfe4e8",ring:"#b4bcc4"},dark:{ground:"#14171b",text:"#e6e6e6",motion:"#56B4E9",border:"#f0803c",stable:"#1fbf92",undecided:"#a0a7ae",family:"#7d848c",velocity:"#CC79A7",momentum:"#f2f2f2",weight:"#a0a7ae",torque:"#a692f0",herpolhode:"#CC79A7",bodyCone:"#9ad4f5",energy:"#F0E442",rotor:"#d29a62",ensemble:"#E69F00",classical:"#a0a7ae",axes:["#56B4E9","#E69F00","#1fbf92"],sphere:"#2a3038",body:"#66727f",edge:"#aab4be",plane:"#2a3038",ring:"#4c5660"}};var $s={light:{...Kf.light,name:"light",lamp:1},dark:{...Kf.dark,name:"dark",lamp:1.1}},Iy=[[],[6,3],[2,2],[8,3,2,3]];function Jf(n,e){let t=[n.motion,n.axes[1],n.stable,n.border,n.bodyCone,n.velocity];return{color:t[e%t.length],dash:Iy[Math.floor(e/t.length)%Iy.length]}}var rI=1600,oI=.05,yt={left:62,right:12,top:10,bottom:24},wo=180/Math.PI,Py=[[1/wo,"\xB0"],[1/wo/60,"\u2032"],[1/wo/3600,"\u2033"],[.001/wo/3600,"mas"]];function aI(n,e,t,i){let s=n.solver?.plots?.(i.map(u=>n.times[u])),r=(u,h,d)=>u.role?{color:t[u.role]}:d?{color:t.axes[h]}:Jf(t,h);if(s)return s.map(({series:u,along:h,...d})=>({...d,series:u.map((f,p)=>({...f,...r(f,p,h)}))}));let o=[],a=n.velocities??n.momenta,l=e.axes??["axis 1","axis 2","axis 3"];a&&o.push({title:n.velocities?"\u03A9 along the body's axes":"L along the body's axes",unit:n.velocities?"rad/s":"kg m\xB2/s",series:l.map((u,h)=>({name:u,color:t.axes[h],values:i.map(d=>a[3*d+h])}))});let c=lI(n,e,t,i,l);c&&o.push(c);for(let{title:u,unit:h,series:d}of e.plots??[])o.push({title:u,unit:h,series:d.map(({name:f,values:p},x)=>{let m=ht(p);return{name:f,...Jf(t,x),values:i.map(g=>m[g])}})});return o}function lI(n,e,t,i,s){if(!n.attitudes)return null;if(e.up==="L"&&n.momenta){let a=(c,u)=>{let h=n.momenta.subarray(3*c,3*c+3);return Math.atan2(Math.hypot(h[(u+1)%3],h[(u+2)%3]),h[u])*wo};return{title:"angles of the axes from L",unit:"\xB0",series:s.map((c,u)=>({name:c,color:t.axes[u],values:i.map(h=>a(h,u))}))}}let r=new C(...e.panels.find(a=>a.axis)?.axis??[0,0,1]).normalize(),o=a=>{let[l,c,u,h]=n.attitudes.subarray(4*a,4*a+4),d=r.clone().applyQuaternion(new rt(c,u,h,l));return Math.atan2(Math.hypot(d.x,d.y),d.z)*wo};return{title:"tilt of the axis from the vertical",unit:"\xB0",series:[{name:"tilt",color:t.motion,values:i.map(o)}]}}var rh=class{constructor(e,t){this.root=e,this.goTo=t,this.plots=[]}take(e,t,i){this.motion=e,this.theme=i;let s=Math.max(1,Math.ceil(e.count/rI)),r=[];for(let l=0;l<e.count;l+=s)r.push(l);r.at(-1)!==e.count-1&&r.push(e.count-1),this.times=r.map(l=>e.times[l]);let o=e.count>1&&e.span>0?aI(e,t,i,r).map(pI):[];for(let{title:l,words:c,x:u,y:h}of t.scatters??[])o.push({title:l,words:c,scatter:[ht(u),ht(h)],color:i.motion});let a=cI(e,i);a&&o.push(a),o.length!==this.plots.length&&(this.root.replaceChildren(...o.map(()=>this.frame())),this.plots=o.map((l,c)=>({figure:this.root.children[c],canvas:this.root.children[c].firstChild}))),this.plots.forEach((l,c)=>{l.what=o[c],l.still=null,dI(l.figure,o[c])})}frame(){let e=document.createElement("figure");e.className="plot";let t=document.createElement("canvas");t.setAttribute("role","img");let i=s=>{if(!this.plots.find(l=>l.canvas===t).what.series||s.type==="pointermove"&&!s.buttons)return;let o=t.getBoundingClientRect(),a=(s.clientX-o.left-yt.left)/(o.width-yt.left-yt.right);this.goTo(this.times[0]+Math.min(1,Math.max(0,a))*(this.times.at(-1)-this.times[0]))};return t.addEventListener("pointerdown",i),t.addEventListener("pointermove",i),e.append(t,document.createElement("figcaption")),e}draw(e){for(let t of this.plots){let{canvas:i,what:s}=t,r=Math.min(window.devicePixelRatio||1,2),[o,a]=[i.clientWidth,i.clientHeight];if(!o||!a)continue;(!t.still||t.width!==o||t.dots!==r)&&(Object.assign(t,{width:o,dots:r,still:this.still(s,o,a,r)}),[i.width,i.height]=[t.still.width,t.still.height]);let l=i.getContext("2d");l.clearRect(0,0,i.width,i.height),l.drawImage(t.still,0,0),l.setTransform(r,0,0,r,0,0),s.path?this.dot(l,s,e,o,a):s.series&&this.cursor(l,e,o,a),l.setTransform(1,0,0,1,0,0)}}still(e,t,i,s){let r=document.createElement("canvas");[r.width,r.height]=[Math.round(t*s),Math.round(i*s)];let o=r.getContext("2d");return o.scale(s,s),o.font="12px system-ui, sans-serif",e.path?hI(o,e,t,i,this.theme):e.scatter?uI(o,e,t,i,this.theme):this.drawCurves(o,e,t,i),r}drawCurves(e,{series:t,unit:i,power:s},r,o){let{times:a,theme:l}=this,[c,u]=Qf(t),h=Ny(a[0],a.at(-1),c,u,r,o);e.fillStyle=l.text,e.strokeStyle=l.ring,e.textBaseline="middle",e.textAlign="right";for(let x of oh(c,u,4)){let[,m]=h(a[0],x);Ao(e,[[yt.left,m],[r-yt.right,m]]),e.fillText(`${Ya(x/10**s)}${i==="\xB0"?"\xB0":""}`,yt.left-6,m)}e.textBaseline="top",e.textAlign="center";let d=a.at(-1)-a[0],[f,p]=cf(d)??[1,"s"];for(let x of oh(a[0]/f,a.at(-1)/f,r>500?6:3))e.fillText(`${Ya(x)} ${p}`,h(x*f,c)[0],o-yt.bottom+7);for(let{color:x,dash:m=[],values:g,times:y=a}of t){[e.strokeStyle,e.fillStyle,e.lineWidth]=[x,x,1.6],e.setLineDash(m);let v=g.map((M,w)=>h(y[w],M));if(this.motion.joined)Ao(e,v);else for(let[M,w]of v)e.fillRect(M-1,w-1,2,2)}e.setLineDash([])}cursor(e,t,i,s){let[r,o]=[this.times[0],this.times.at(-1)],a=yt.left+(t.time-r)/(o-r||1)*(i-yt.left-yt.right);e.strokeStyle=this.theme.text,e.lineWidth=1.2,Ao(e,[[a,yt.top],[a,s-yt.bottom]])}dot(e,t,i,s,r){let[o,a]=Ly(t,s,r)(t.flat(i.momentum.clone().normalize()));e.fillStyle=this.theme.velocity,e.beginPath(),e.arc(o,a,5,0,2*Math.PI),e.fill()}probe(){return this.plots.map(({what:e})=>({title:e.title,ranges:(e.series??[]).map(({values:t})=>[Math.min(...t),Math.max(...t)]),styles:(e.series??[]).map(({color:t,dash:i=[]})=>({color:t,dash:i})),across:e.across??null}))}};function cI(n,e){if(!n.free)return null;let t=n.at(0).momentum;if(!(t.length()>0))return null;let i=ur(n.free,t.toArray()),s=t.clone().normalize().toArray(),r=s.reduce((f,p,x)=>Math.abs(p)>Math.abs(s[f])?x:f,0);if(!i)return null;let o=Math.sign(s[r]),a=f=>[f.getComponent((r+1)%3)*o,f.getComponent((r+2)%3)],l=[];for(let f=0;f<i.length;f+=3)l.push(a(new C(i[f],i[f+1],i[f+2])));let c=Math.max(...l.map(([f,p])=>Math.hypot(f,p)));if(!(c<oI)||c<1e-14)return null;let[u,h]=Py.find(([f])=>2*c>=f)??Py.at(-1),d=`${Ya(2*c/u,3)}${h.length>1?" ":""}${h}`;return{title:["the polhode from above, {across} across: the sphere magnified {times} times",{across:d,times:et(1/c,1)}],across:d,path:l,flat:a,most:c,color:e.motion,unit:u,name:h}}var Ly=({most:n},e,t)=>{let i=(.5*Math.min(e,t)-22)/n;return([s,r])=>[.5*e+i*s,.5*t-i*r]};function uI(n,{scatter:[e,t],color:i},s,r,o){let[[a,l],[c,u]]=[e,t].map(f=>Qf([{values:f}])),h=Ny(a,l,c,u,s,r);[n.fillStyle,n.textBaseline,n.textAlign]=[o.text,"middle","right"];for(let f of oh(c,u,4))n.fillText(Ya(f),yt.left-6,h(a,f)[1]);[n.textBaseline,n.textAlign]=["top","center"];for(let f of oh(a,l,6))n.fillText(Ya(f),h(f,c)[0],r-yt.bottom+7);n.strokeStyle=o.ring,n.strokeRect(yt.left,yt.top,s-yt.left-yt.right,r-yt.top-yt.bottom),n.fillStyle=i;let d=e.length<500?3:1.6;for(let f=0;f<e.length;f++){let[p,x]=h(e[f],t[f]);n.fillRect(p-.5*d,x-.5*d,d,d)}}function hI(n,e,t,i,s){let r=Ly(e,t,i);n.strokeStyle=s.ring,Ao(n,[[.5*t-8,.5*i],[.5*t+8,.5*i]]),Ao(n,[[.5*t,.5*i-8],[.5*t,.5*i+8]]),[n.strokeStyle,n.lineWidth]=[e.color,2],Ao(n,e.path.map(r))}function dI(n,{title:e,words:t="",unit:i,series:s,path:r,power:o}){let a=document.createElement("strong"),l=o?`10${[...String(o)].map(d=>lf[d]).join("")} `:"";a.textContent=i&&!r?`${W(e)} [${l}${W(i)}]`:W(e);let c=document.createElement("span");c.className="legend";for(let{name:d,color:f,dash:p=[]}of s?.length>1?s:[]){let[x,m]=[document.createElement("span"),document.createElement("i")];m.style.background=fI(f,p),x.append(m,W(d)),c.append(x)}let u=document.createElement("span");u.className="words",u.textContent=W(t),n.lastChild.replaceChildren(a,u,c);let h=r?W("with the point that moves"):s?W("over time"):"";n.firstChild.setAttribute("aria-label",`${[a.textContent,W(t),h].filter(Boolean).join(", ")}.`)}function fI(n,e){if(!e.length)return n;let t=0;return`repeating-linear-gradient(90deg, ${e.map((s,r)=>{let[o,a]=[t,t+=s];return`${r%2?"transparent":n} ${o}px ${a}px`}).join(", ")})`}function pI(n){let e=Math.max(...Qf(n.series).map(Math.abs)),t=n.unit==="\xB0"||!(e>0)||e>=.01&&e<1e4;return{...n,power:t?0:Math.floor(Math.log10(e))}}var Ya=(n,e=6)=>String(Number(n.toPrecision(e))).replace("-","\u2212");function Qf(n){let[e,t]=[1/0,-1/0];for(let{values:s}of n)for(let r of s)e=Math.min(e,r),t=Math.max(t,r);let i=t-e>1e-9*Math.max(Math.abs(e),Math.abs(t))?.06*(t-e):.5*Math.abs(t)||1;return[e-i,t+i]}function Ny(n,e,t,i,s,r){let[o,a]=[s-yt.left-yt.right,r-yt.top-yt.bottom];return(l,c)=>[yt.left+(l-n)/(e-n||1)*o,yt.top+(i-c)/(i-t)*a]}function oh(n,e,t){let i=(e-n)/t,s=10**Math.floor(Math.log10(i)),r=[1,2,5,10].find(a=>a*s>=i)*s,o=[];for(let a=Math.ceil(n/r);a*r<=e;a++)o.push(a*r);return o}function Ao(n,e){n.beginPath(),e.forEach(([t,i],s)=>s?n.lineTo(t,i):n.moveTo(t,i)),n.stroke()}var Za=n=>document.getElementById(n),ah=class{constructor(e,t,i){this.presets=e,this.act=i,Za("playground").hidden=!1,document.documentElement.dataset.playground="",this.buttons=e.map((s,r)=>{let o=document.createElement("button");return o.type="button",o.addEventListener("click",()=>t(this.choose(r))),o}),Za("presets").replaceChildren(...this.buttons),this.write()}write(){this.buttons.forEach((t,i)=>t.textContent=W(this.presets[i].title));let e=this.buttons.findIndex(t=>t.getAttribute("aria-pressed")==="true");e>=0&&this.choose(e)}find(e){let t=this.presets.findIndex(({key:o})=>o===e),i=this.choose(Math.max(0,t)),[s,r]=[Za("presets"),this.buttons[Math.max(0,t)]];return s.scrollLeft+=r.getBoundingClientRect().left-.5*(s.clientWidth-r.offsetWidth),e&&t<0&&this.tell(W("The playground has no motion called {named}; it has {keys}.",{named:String(e),keys:this.presets.map(({key:o})=>o).join(", ")})),i}tell(e){let t=document.createElement("li");t.textContent=e,Za("story").prepend(t)}choose(e){return this.buttons.forEach((t,i)=>t.setAttribute("aria-pressed",String(i===e))),Za("story").replaceChildren(...this.presets[e].story.map(t=>this.sentence(t))),this.presets[e]}sentence(e){let t=document.createElement("li"),i=W(e.say),[,s,r,o]=/^(.*?)\[(.+?)\](.*)$/s.exec(i)??[null,`${i} `,e.set&&W(e.label??"Show it"),""];if(t.append(s),!r)return t;let a=document.createElement("button");return Object.assign(a,{type:"button",textContent:r}),a.addEventListener("click",()=>this.act(e)),a.addEventListener("pointerup",()=>a.blur()),t.append(a,o),t}};var mI={momentum_norm:"|L|",momentum_space:"L in space","|L|\xB2":"|L|\xB2"},lh=class{constructor(e,t,i){this.list=e,this.take(t,i)}take(e,t,i=!1){this.data=t,this.rows={},this.list.replaceChildren();for(let[a,l]of[...e.energies?[["energy",t.energyName]]:[],...e.momenta?[["momentum","|L|"]]:[],...e.velocities?[["velocity","|\u03A9|"]]:[]])this.rows[a]=this.row(l);let s=Object.entries(t.drift);if(!s.length||i)return;let r=s.reduce((a,l)=>l[1]>a[1]?l:a),o=(mI[r[0]]??r[0]).replaceAll("_"," ");this.row("largest drift").textContent=`${et(r[1],2)} (${W(o)})`}row(e){let[t,i]=[document.createElement("dt"),document.createElement("dd")];t.textContent=W(e);let s=document.createElement("div");return s.append(t,i),this.list.append(s),i}show(e){let t=(r,o)=>{this.rows[r]&&this.rows[r].textContent!==o&&(this.rows[r].textContent=o)},{energy:i=[1,this.data.energyUnit],momentum:s=[1,"kg m\xB2/s"]}=this.data.units??{};e.energy!==null&&t("energy",`${et(e.energy/i[0])} ${i[1]}`),e.momentum&&t("momentum",`${et(e.momentum.length()/s[0])} ${s[1]}`),e.velocity&&t("velocity",`${et(e.velocity.length(),5)} rad/s`)}};var gI=[["video/webm;codecs=vp9","webm"],["video/webm;codecs=vp8","webm"],["video/webm","webm"],["video/mp4","mp4"]];var Dy=()=>typeof MediaRecorder<"u"&&typeof HTMLCanvasElement.prototype.captureStream=="function"&&!!Uy(),Uy=()=>gI.find(([n])=>MediaRecorder.isTypeSupported(n)),ch=class{constructor(e,t,i){let[s,r]=Uy();this.canvas=e,this.begun=performance.now();let o=[],a=e.captureStream(30);this.recorder=new MediaRecorder(a,{mimeType:s,videoBitsPerSecond:8e6}),this.recorder.addEventListener("dataavailable",({data:l})=>l.size&&o.push(l)),this.recorder.addEventListener("stop",()=>{for(let l of a.getTracks())l.stop();i(o.length?new Blob(o,{type:s}):null,r)}),this.recorder.start(),this.waiting=setTimeout(()=>this.close(),1e3*t)}get passed(){return(performance.now()-this.begun)/1e3}paint(e){this.draw=e,e(this.canvas)}close(){this.draw?.(this.canvas),this.waiting=setTimeout(()=>this.stop(),3e3/30)}stop(){clearTimeout(this.waiting),this.recorder.state!=="inactive"&&this.recorder.stop()}};var xI=760,[ep,yI,tp]=[.5,10,60],Xn=n=>document.getElementById(n),uh=class{constructor(e){this.page=e;let t=(i,s)=>Xn(i).addEventListener("click",s);t("link",()=>this.copyLink()),t("embed",()=>this.copyEmbedCode()),t("spec",()=>this.copySpec()),t("picture",()=>this.savePicture()),t("film",()=>this.film?this.film.stop():this.saveFilm()),Xn("film-length").addEventListener("change",()=>this.check())}take(){Xn("spec").hidden=!this.page.instrument?.kind.toml;for(let e of["copied","saved"])Xn(e).hidden=!0;this.say(""),this.given=null,this.suggest()}say(e,t){Xn("shared").textContent=W(e,t)}async copy(e,t){let i=Xn("copied");i.value=e,i.hidden=!1;try{await navigator.clipboard.writeText(e),this.say(t)}catch{this.say("This browser keeps the clipboard from pages in frames: copy the text from the field below."),i.select()}}copyLink(){let{whole:e,fragment:t}=this.page.address;return e===null?this.copy(`#${t}`,"A page in a notebook has no address of its own. Write it to a file with write_page, and add this to the file's address."):this.copy(e,e.startsWith("file:")?"The link is copied. It opens on this computer only: put the file on a web server to give it to others.":"The link is copied.")}copyEmbedCode(){let{whole:e}=this.page.address;if(e===null)return this.say("A page in a notebook has no address that another page could embed. Write it to a file with write_page, and put the file on a web server.");let t=`polhode: ${Xn("name").textContent}`,[i,s]=[e,t].map(o=>o.replaceAll("&","&amp;").replaceAll('"',"&quot;").replaceAll("<","&lt;")),r=`<iframe src="${i}" title="${s}" loading="lazy" sandbox="allow-scripts allow-downloads" allow="clipboard-write" style="width:100%; height:${xI}px; border:0"></iframe>`;return this.copy(r,"The code is copied: paste it into the HTML of a page.")}copySpec(){let e=this.page.instrument.toml(this.page.motion.span);return e===null?this.say("No spec says this start. A gyrostat needs its rotor's moment, and a free rotor a principal axis; a disk must begin in steady rolling."):this.copy(e,"The spec is copied: paste it into a file, and run polhode report on it.")}savePicture(){let e=this.page.shot();if(Fy()){let t=Xn("saved");return t.src=e.toDataURL("image/png"),t.hidden=!1,this.say("A frame like this one may not save files: save the picture below by a right click, or by a long press.")}return e.toBlob(t=>this.save(t,"png"),"image/png"),this.say("The picture is saved.")}saveFilm(){if(!Dy())return this.say("This browser cannot record films: it has no MediaRecorder for canvases. Firefox and Chromium have.");let e=this.check();if(e===null)return;let{timebar:t}=this.page,i=t.playing,s=()=>this.say("Recording: {passed} of {seconds} s.",{passed:$t(Math.min(this.film.passed,e).toFixed(1)),seconds:et(e,3)}),r=setInterval(s,200);return this.film=new ch(this.page.shot(),e,(o,a)=>{clearInterval(r),this.film=null,Xn("film").textContent=W("Save film"),i||t.pause(),o&&this.save(o,a),this.say(o?Fy()?"The film is recorded. If it was not saved, this frame may not save files: open the page on its own.":"The film is saved.":"The browser has recorded nothing.")}),Xn("film").textContent=W("Stop"),i||t.toggle(),s()}frame(){this.film?.paint(e=>this.page.shot(e))}suggest(){if(this.given!==null)return;let{instrument:e,motion:t,timebar:i}=this.page,{period:s=null,nutationPeriod:r=null}=t?.solver??{},a=([s,r,e?.event??null].find(c=>c!==null&&Number.isFinite(c)&&c>0)??t?.span??0)/i.rate,l=a>0&&Number.isFinite(a)?Math.min(tp,Math.max(ep,a)):yI;Xn("film-length").value=$t(String(Number(l.toFixed(1))))}check(){let e=Xn("film-length"),t=Number(e.value.trim().replace(",",".")),i=e.value.trim()!==""&&t>=ep&&t<=tp;e.setAttribute("aria-invalid",String(!i));let s=e.value.trim()||W("nothing");return this.say(i?"":"A film takes {least} to {most} s; got {got}. Type a number between these.",{least:ep,most:tp,got:s}),this.given=i?t:this.given,i?t:null}save(e,t){let i=document.createElement("a");i.href=URL.createObjectURL(e),i.download=`${Xn("name").textContent.replace(/[^\p{L}\p{N}]+/gu,"-").replace(/^-+|-+$/g,"")||"motion"}.${t}`,i.click(),setTimeout(()=>URL.revokeObjectURL(i.href),6e4)}};function Fy(){try{return window.self!==window.top&&!window.localStorage}catch{return!0}}var ls={s:["sec","secs","second","seconds"],ms:["msec","millisecond","milliseconds"],us:["usec","\xB5s","\u03BCs","microsecond","microseconds"],ns:["nsec","nanosecond","nanoseconds"],min:["mins","minute","minutes"]},Oy={deg:["\xB0","degs","degree","degrees"],rad:["rads","radian","radians"]},cs={"deg/s":["\xB0/s","deg/sec","degree/s","degrees/s","degrees/sec","dps","deg s-1","deg s^-1","deg_s","deg_per_s","deg_per_sec"],"rad/s":["rad/sec","radian/s","radians/s","radians/sec","rad s-1","rad s^-1","rad_s","rad_per_s","rad_per_sec"],rpm:["rev/min","r/min"]},np={"deg/s":Math.PI/180,"rad/s":1,rpm:Math.PI/30},_I={"m/s\xB2":1,"m/s^2":1,"m/s2":1,"m/s/s":1,g:9.80665},By=/^(.*?)\s*[[(]([^\])]*)[\])]\s*$/;function hh(n,e){let t=n.trim().toLowerCase().split(/\s+/).join(" ");return Object.keys(e).find(i=>i===t||e[i].includes(t))??null}function vI(n){let e=By.exec(n);return e?.[1]?e[1]:n.trim()}function gr(n,e){let t=By.exec(n);if(t)return hh(t[2],e);let i=n.trim().toLowerCase().split("_");for(let s=Math.min(4,i.length-1);s>0;s--){let r=hh(i.slice(-s).join("_"),e);if(r)return r}return null}var _i=(n,e="xyz")=>[...e].map(t=>n.replace("{}",t)),MI=[{name:"AndroSensor",time:["time since start in ms"],timeUnit:"ms",gyro:_i("gyroscope {}"),rateUnit:"rad/s",acceleration:[_i("accelerometer {}")],perUnit:1},{name:"phyphox",time:["time"],timeUnit:"s",gyro:_i("gyroscope {}"),rateUnit:"rad/s",acceleration:[_i("acceleration {}"),_i("accelerometer {}")],perUnit:1},{name:"Sensor Logger",time:["seconds_elapsed"],timeUnit:"s",gyro:_i("{}"),rateUnit:"rad/s",acceleration:[_i("{}")],perUnit:1},{name:"Sensor Logger, all in one file",time:["seconds_elapsed"],timeUnit:"s",gyro:_i("gyroscope_{}"),rateUnit:"rad/s",acceleration:[_i("totalacceleration_{}")],perUnit:1},{name:"Betaflight",time:["time"],timeUnit:"us",gyro:_i("gyroadc[{}]","012"),rateUnit:"deg/s",acceleration:[_i("accsmooth[{}]","012")],perUnit:null}];function ja(n,e){let t=e.map(i=>n.flatMap((s,r)=>s.trim().toLowerCase()===i||vI(s).trim().toLowerCase()===i?[r]:[]));return t.every(i=>i.length===1)?t.map(([i])=>i):null}function ip(n,e){for(let t of e.time){let i=ja(n,[t]);if(i)return i[0]}return null}var ky=n=>MI.find(e=>ja(n,e.gyro)&&ip(n,e)!==null)??null;function zy(n,e){let t=n.includes("(")?n.trim().slice(n.trim().lastIndexOf("(")+1).replace(/[) ]+$/,"").toLowerCase():"";return _I[t]??e.perUnit}var dt=class extends Error{},Ka=n=>`"${n.length>60?`${n.slice(0,57)}...`:n}"`;var _t=n=>Ja(n,.5);function Ja(n,e){let t=Float64Array.from(n).sort();if(!t.length)return NaN;let i=e*(t.length-1),s=Math.floor(i),r=Math.min(s+1,t.length-1);return t[s]+(i-s)*(t[r]-t[s])}function zi(n){let e=Math.floor(n);return n-e!==.5?Math.round(n):e%2===0?e:e+1}var zt=n=>Float64Array.from({length:Math.max(n.length-1,0)},(e,t)=>n[t+1]-n[t]);function us(n){let e=[];for(let t=0;t<n.length;t++){if(!n[t])continue;let i=t;for(;t<n.length&&n[t];)t+=1;e.push([i,t])}return e}function $n(n,e,t=!1){let[i,s]=[0,n.length];for(;i<s;){let r=i+s>>1;n[r]<e||t&&n[r]===e?i=r+1:s=r}return i}function vi(n){return Float64Array.from({length:n.length/3},(e,t)=>Math.hypot(n[3*t],n[3*t+1],n[3*t+2]))}var xr=(n,e)=>Float64Array.from({length:n.length/3},(t,i)=>n[3*i+e]);function hs(n,e=0,t=n.length/3){let i=[0,0,0];for(let s=e;s<t;s++)for(let r=0;r<3;r++)i[r]+=n[3*s+r];return i.map(s=>s/(t-e))}function dh(n,e=3){let t=[];for(let i of n)for(let s=0;s+3*e<i.length;s++)t.push(Math.abs(i[s+3*e]-3*i[s+2*e]+3*i[s+e]-i[s]));return t.length?_t(t)/(.6745*Math.sqrt(20)):0}var rp=[";","	",","," "],fh=60,Hy=2e3,Gy=1e6,bI=new Set(["","nan","na","n/a","null","none","-"]),Wy=/^(?:[+-]?(?:\d+[.,]?\d*|[.,]\d+)(?:e[+-]?\d+)?|[+-]?(?:nan|inf|infinity))$/i,SI=/^[+-]?[\d.]+(?:[eE][+-]?\d+)?\s+[+-]?[\d.]+(?:[eE][+-]?\d+)?$/,wI=/^[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d{1,6})?$/,qy=/^[+-]?\d*,\d+(?:[eE][+-]?\d+)?$/,AI=/"[^"]*"|[^\s[("]+(?:[ \t]*(?:\[[^\]]*\]|\([^)]*\)))?/g;function Xy(n){let e=n.replace(/^\uFEFF/,"").split(/\r\n|\n|\r/);return e.at(-1)===""&&e.pop(),e.map((t,i)=>{if(t.includes("\0")||t.includes("\uFFFD"))throw new dt(W("line {line} is not UTF-8 text, so this is not a table. Choose the app's CSV file, unpacked from its archive.",{line:i+1}));if(t.length>Gy)throw new dt(W("line {line} has more than {most} characters. Choose a table with one sample in each line.",{line:i+1,most:Gy}));return{number:i+1,text:t}})}var ph=n=>/^\s*(?:[#%]|$)/.test(n);function Eo(n,e){if(!n.includes('"')){let r=n.trim();return e===" "?r?r.split(/\s+/):[]:n.split(e).map(o=>o.trim())}let t=e===" "?n.trim().split(/\s+/).join(" "):n,i=[],s=0;for(;;){for(;t[s]===" "&&e!==" ";)s+=1;let r="";if(t[s]==='"'){for(s+=1;t[s]!=='"'||t[s+1]==='"';s++){if(s>=t.length)return null;t[s]==='"'&&(s+=1),r+=t[s]}if(s+=1,s<t.length&&t[s]!==e)return null}else{let o=t.indexOf(e,s);r=o<0?t.slice(s):t.slice(s,o),s=o<0?t.length:o}if(i.push(r.trim()),s>=t.length)return i;s+=1}}function op(n){let e=n.slice(0,Hy+fh),t=e.filter(({text:d})=>!ph(d)).slice(0,fh),s=rp.map(d=>({delimiter:d,...EI(t,d)})).reduce((d,f)=>f.count>d.count?f:d);if(!s.count){let d=t.length?W("its first line is {text}",{text:Ka(t[0].text)}):W("it is empty");throw new dt(W("it has no line of numbers in two columns or more, between commas, semicolons, tabs or blanks; {first}. Choose a table with one sample in each line.",{first:d}))}let{delimiter:r,begin:o}=s,a=Eo(t[o].text,r),l=t[o].number,c=d=>({delimiter:r,width:a.length,names:d,first:l}),u=e.filter(({number:d,text:f})=>ph(f)&&f.trim()&&d<t[0].number).slice(-1);if(o>1){let d=RI(t[o-2].text,t[o-1].text,r,a);if(d.length)return c(d)}let h=o?[t[o-1]]:u;for(let{text:d}of h){let f=sp(d,r,a);if(f.length)return c(f)}if(o){let{number:d,text:f}=h[0];throw new dt(W("line {line} must name the {columns} columns that line {first} has; got {names} names. Name each, or delete the line.",{line:d,columns:a.length,first:l,names:Yy(f,r).length}))}return c([])}function EI(n,e){let t=null,i=[];return n.forEach(({text:s},r)=>{let o=Eo(s,e)??[];t===null&&TI(o)&&(t=r),t!==null&&i.push(o.length)}),t===null?{count:0,begin:0}:{count:i.filter(s=>s===i[0]).length,begin:t}}function TI(n){let e=n.filter(Boolean),t=e.filter(i=>Wy.test(i));return n.length>1&&2*t.length>e.length&&!e.some(i=>SI.test(i))}var $y=n=>n.trimStart().replace(/^[#%]+/,""),Yy=(n,e)=>Eo($y(n),e)??[];function sp(n,e,t){let i=Yy(n,e);return e===" "&&i.length!==t.length&&(i=($y(n).match(AI)??[]).map(r=>r.replace(/^"+|"+$/g,""))),i.length===t.length-1&&!t.at(-1)&&(i=[...i,""]),i.length===t.length&&i.some(Boolean)&&!i.some(r=>Wy.test(r))?i:[]}var Vy=n=>[ls,Oy,cs].some(e=>hh(n,e));function RI(n,e,t,i){let s=sp(n,t,i),r=sp(e,t,i).map(o=>o.replace(/^[[\]()]+|[[\]()]+$/g,""));return!s.length||!r.some(Vy)||s.some(Vy)?[]:s.map((o,a)=>r[a]?`${o} [${r[a]}]`:o)}function Zy(n,e){if(e.delimiter===",")return"point";let i=n.slice(0,Hy+fh).filter(({number:s,text:r})=>s>=e.first&&!ph(r)).slice(0,fh).flatMap(({text:s})=>s.split(e.delimiter).map(r=>r.replace(/^[ "]+|[ "]+$/g,"")));return i.some(s=>qy.test(s))&&!i.some(s=>s.includes("."))?"comma":"point"}function jy(n,e,t,i){let s=t.map(()=>[]),r=[];for(let{number:o,text:a}of n){if(o<e.first||ph(a))continue;let l=Eo(a,e.delimiter);if(!l)throw new dt(W("line {line} has quotes that do not close. Check the line.",{line:o}));for(;l.length>e.width&&!l.at(-1);)l.pop();if(l.length!==e.width){let c=e.delimiter===","?"line {line} has {cells} cells, and line {first} has {width}. Check the line, or delete it. Is the comma a decimal one? Then save it with semicolons.":"line {line} has {cells} cells, and line {first} has {width}. Check the line, or delete it.";throw new dt(W(c,{line:o,cells:l.length,first:e.first,width:e.width}))}t.forEach((c,u)=>s[u].push(CI(l[c],i,()=>W("line {line}, {column}",{line:o,column:ap(e,c)})))),r.push(i==="comma"?l[t[0]].replaceAll(",","."):l[t[0]])}return{numbers:s.map(o=>Float64Array.from(o)),texts:r}}function CI(n,e,t){if(bI.has(n.toLowerCase()))return NaN;if(e==="comma"&&n.includes("."))throw new dt(W("{where}: {cell} has a point, and the other numbers have decimal commas. Choose one of them.",{where:t(),cell:Ka(n)}));let i=e==="comma"&&qy.test(n)?n.replace(",","."):n,s=wI.test(i)?Number(i):NaN;if(Number.isFinite(s)&&!(s===0&&/^[+-]?[0.]*[1-9]/.test(i)))return s;let r=Number.isNaN(s)?"must be a number in decimal digits":s===0?"is so small that nothing is left of it":"is too large for a number",o=i.includes(":")?"Dates and times of day are not read: give times as plain numbers, like seconds from the start.":"Correct it, or leave the cell blank.";throw new dt(`${t()}: ${Ka(n)} ${W(r)}. ${W(o)}`)}var mh=n=>W("column {column}",{column:n+1}),ap=(n,e)=>n.names[e]?`${mh(e)} ${Ka(n.names[e])}`:mh(e);var Ky=8,II=3,PI=.02,LI=1.1,Jy=1e12,lp=1e-9,NI=1e-10,DI={s:0,ms:3,us:6,ns:9},UI={s:1,ms:1e3,us:1e6,ns:1e9},n_=40;function i_(n){let e=Xy(n);for(let t=0;t<Math.min(e.length,2e3);t++)for(let i of rp){let s=ky(Eo(e[t].text,i)??[]);if(!s)continue;let r=e.slice(t);if(!r.slice(1).some(o=>/[^ \t;,]/.test(o.text)))throw new dt(W("no sample stands below the header in line {line}. Log again.",{line:e[t].number}));return{form:op(r),dialect:s,lines:e}}return{form:op(e),dialect:null,lines:e}}function s_({form:n,dialect:e}){let{names:t}=n;if(e){let[a,l]=[ip(t,e),ja(t,e.gyro)],c=Qy(l.map(u=>t[u]),cs);return{time:a,timeUnit:gr(t[a],ls)??e.timeUnit,gyro:l,rateUnit:gr(t[l[0]],cs)?c:e.rateUnit}}let i=t.flatMap((a,l)=>gr(a,ls)?[l]:[]),s=t.flatMap((a,l)=>gr(a,cs)?[l]:[]),r=i.length===1?i[0]:null,o=s.length===3?s:null;return{time:r,timeUnit:r===null?null:gr(t[r],ls),gyro:o,rateUnit:o&&Qy(o.map(a=>t[a]),cs)}}function Qy(n,e){let t=new Set(n.map(i=>gr(i,e)).filter(Boolean));return t.size===1?[...t][0]:null}function r_({form:n,dialect:e,lines:t},i){if(i.time===null||!i.gyro||i.gyro.includes(null))throw new dt(W("it is not known which columns have the time and the angular velocities: no app that is known writes such a header. Choose them."));let s=[i.time,...i.gyro],r=s.find((p,x)=>s.indexOf(p)<x);if(r!==void 0)throw new dt(W("{column} is chosen twice. Choose another column for each.",{column:ap(n,r)}));if(!(i.rateUnit in np))throw new dt(W("the unit of the angular velocity is not known: the file does not say it. Choose deg/s, rad/s or rpm."));if(!(i.timeUnit in ls))throw new dt(W("the unit of the time is not known: the file does not say it. Choose it."));let o=[],a=e?FI(n,e,o):null,{numbers:l,texts:c}=jy(t,n,[...s,...a?a.places:[]],Zy(t,n)),u=OI(l[0],c,i.timeUnit),h=t_("rates",u,e_(l.slice(1,4),np[i.rateUnit]));if(h.times.length<Ky)throw new dt(W("a gyro log must have {least} finite samples at different times; this one has {count}. Log for longer.",{least:Ky,count:h.times.length}));let d=a?t_("accelerations",u,e_(l.slice(4,7),a.unit)):null,f=!!d?.times.length;return{times:h.times,rates:h.values,accelerationTimes:f?d.times:null,acceleration:f?d.values:null,dialect:e?.name??null,rateUnit:i.rateUnit,notes:[...o,...h.notes]}}function FI(n,e,t){for(let i of e.acceleration){let s=i.join()===e.gyro.join()?null:ja(n.names,i);if(!s)continue;let r=zy(n.names[s[0]],e);return r!==null?{places:s,unit:r}:(t.push(W("Accelerations are left out, as their unit is not known.")),null)}return null}function e_(n,e){let t=new Float64Array(3*n[0].length);return n.forEach((i,s)=>i.forEach((r,o)=>{t[3*o+s]=r*e})),t}function OI(n,e,t){let i=n.map(o=>t==="min"?60*o:o/UI[t]),s=i.reduce((o,a)=>Number.isFinite(a)?Math.max(o,Math.abs(a)):o,0);if(s===0||2**(Math.floor(Math.log2(s))-52)<=NI)return i;let r=null;return i.map((o,a)=>{if(!Number.isFinite(o))return NaN;let l=BI(e[a],DI[t]??0)*(t==="min"?60n:1n);return r??=l,Number(l-r)/10**n_})}function BI(n,e){let[,t,i,s="",r="0"]=/^([+-]?)(\d*)\.?(\d*)(?:[eE]([+-]?\d+))?$/.exec(n.trim()),o=n_-s.length+Number(r)-e,a=BigInt(i+s||"0"),l=o>=0?a*10n**BigInt(o):a/10n**BigInt(-o);return t==="-"?-l:l}function t_(n,e,t){let i=Array.from(e.keys()).filter(y=>Number.isFinite(e[y])&&[0,1,2].every(v=>Number.isFinite(t[3*y+v]))),s=[];i.length<e.length&&s.push(W("{count} lines without finite values are left out.",{count:e.length-i.length}));let r=y=>({t:Float64Array.from(y,v=>e[v]),x:Float64Array.from(y.flatMap(v=>[t[3*v],t[3*v+1],t[3*v+2]]))}),{t:o,x:a}=r(i);kI(n,o,a);let l=zt(o),c=l.filter(y=>y!==0).map(Math.abs),u=c.length?_t(c):lp;if(u<lp)throw new dt(W("times of {what} must lie {least} s apart or more; got {got} s. Check which column has the times, and their unit.",{what:W(n),least:lp,got:u}));if(l.every(y=>y>0))return{times:o,values:a,notes:s};l.some(y=>y<0)&&s.push(W("Lines are not in the order of time; they were sorted.")),i=i.sort((y,v)=>e[y]-e[v]),{t:o,x:a}=r(i);let h=y=>y===0||o[y]>o[y-1],d=y=>h(y)||[0,1,2].some(v=>a[3*y+v]!==a[3*y-3+v]),f=Array.from(o.keys()),p=f.filter(y=>d(y)&&!h(y)).length,x=p>=Math.max(II,PI*o.length),m=f.filter(x?d:h);m.length<o.length&&s.push(W("{count} samples come at a time that was there already; the first of each is kept.",{count:o.length-m.length})),x&&s.push(W("The clock is rounded: {count} samples come at a time that was there already, with other values; they are taken at equal steps.",{count:p}));let g=r(m.map(y=>i[y]));return{times:x?zI(g.t):g.t,values:g.x,notes:s}}function kI(n,e,t){for(let[i,s]of[["times",e],[n,t]]){let r=s.reduce((o,a)=>Math.max(o,Math.abs(a)),0);if(r>Jy)throw new dt(W("{what} must be at most {most} in SI units; got {got}. Check which columns they are, and their unit.",{what:W(i),most:Jy,got:r}))}}function zI(n){let e=Array.from(n.keys()).filter(h=>h===0||n[h]>n[h-1]),t=e.length>1?_t(zt(e.map(h=>n[h]))):0,i=Float64Array.from(n);e.forEach((h,d)=>{let f=e[d+1]??n.length,p=Math.min(f<n.length?n[f]-n[h]:t,t);for(let x=h;x<f;x++)i[x]=n[h]+(x-h)/(f-h)*p});let s=n.length,r=.5*(s-1),o=n.reduce((h,d)=>h+d,0)/s,a=n.reduce((h,d,f)=>h+(f-r)*(d-o),0)/(s*(s*s-1)/12),l=n.map((h,d)=>h-(o+a*(d-r))),[c,u]=l.reduce(([h,d],f)=>[Math.min(h,f),Math.max(d,f)],[1/0,-1/0]);return u-c<=LI*t?Float64Array.from({length:s},(h,d)=>n[0]+a*d):i}function To(n){let e=n.length,t=n.map(r=>Float64Array.from(r)),i=n.map((r,o)=>Float64Array.from({length:e},(a,l)=>o===l?1:0));for(let r=0;r<60;r++){let o=!1;for(let a=0;a<e-1;a++)for(let l=a+1;l<e;l++){let c=t[a][l];if(Math.abs(c)<=1e-17*Math.sqrt(Math.abs(t[a][a]*t[l][l]))||Math.abs(c)<1e-300)continue;o=!0;let[u,h]=a_(t[a][a],c,t[l][l]);for(let d=0;d<e;d++)[t[d][a],t[d][l]]=[u*t[d][a]-h*t[d][l],h*t[d][a]+u*t[d][l]];for(let d=0;d<e;d++)[t[a][d],t[l][d]]=[u*t[a][d]-h*t[l][d],h*t[a][d]+u*t[l][d]];t[a][l]=t[l][a]=0;for(let d=0;d<e;d++)[i[d][a],i[d][l]]=[u*i[d][a]-h*i[d][l],h*i[d][a]+u*i[d][l]]}if(!o)break}let s=t.map((r,o)=>o).sort((r,o)=>t[r][r]-t[o][o]);return{values:s.map(r=>t[r][r]),vectors:s.map(r=>i.map(o=>o[r]))}}function a_(n,e,t){let i=(t-n)/(2*e),s=(i<0?-1:1)/(Math.abs(i)+Math.hypot(i,1)),r=1/Math.hypot(s,1);return[r,s*r]}function l_(n){let e=n.length,t=n.map((r,o)=>Float64Array.from({length:e},(a,l)=>o===l?1:0));for(let r=0;r<60;r++){let o=!1;for(let a=0;a<e-1;a++)for(let l=a+1;l<e;l++){let[c,u]=[n[a],n[l]],[h,d,f]=[Mi(c,c),Mi(c,u),Mi(u,u)];if(Math.abs(d)<=1e-16*Math.sqrt(h*f)||d===0)continue;o=!0;let[p,x]=a_(h,d,f);o_(c,u,p,x),o_(t[a],t[l],p,x)}if(!o)break}let i=n.map(r=>Math.sqrt(Mi(r,r))),s=i.map((r,o)=>o).sort((r,o)=>i[o]-i[r]);return{values:s.map(r=>i[r]),vectors:s.map(r=>Array.from(t[r]))}}function o_(n,e,t,i){for(let s=0;s<n.length;s++){let[r,o]=[n[s],e[s]];n[s]=t*r-i*o,e[s]=i*r+t*o}}function Mi(n,e){let t=0;for(let i=0;i<n.length;i++)t+=n[i]*e[i];return t}function gh(n,e){let t=e.length,i=n.map((r,o)=>[...r,e[o]]);for(let r=0;r<t;r++){let o=r;for(let a=r+1;a<t;a++)Math.abs(i[a][r])>Math.abs(i[o][r])&&(o=a);if([i[r],i[o]]=[i[o],i[r]],i[r][r]===0||!Number.isFinite(i[r][r]))return null;for(let a=r+1;a<t;a++){let l=i[a][r]/i[r][r];for(let c=r;c<=t;c++)i[a][c]-=l*i[r][c]}}let s=new Array(t);for(let r=t-1;r>=0;r--){let o=i[r][t];for(let a=r+1;a<t;a++)o-=i[r][a]*s[a];s[r]=o/i[r][r]}return s}var Ys=(n,e)=>[n[1]*e[2]-n[2]*e[1],n[2]*e[0]-n[0]*e[2],n[0]*e[1]-n[1]*e[0]],xh=([n,e,t])=>Mi(n,Ys(e,t));var c_=Math.SQRT2,u_=[[0,1],[0,2],[1,2]],GI=.02,VI=.5,HI=2,[WI,qI]=[75,.6],XI=5,$I=Math.PI/180,YI=([n,e,t,i],[s,r,o,a])=>[n*s-e*r-t*o-i*a,n*r+e*s+t*a-i*o,n*o-e*a+t*s+i*r,n*a+e*o-t*r+i*s];function cp(n){let e=Math.hypot(...n),t=e<.001?.5-e*e/48:Math.sin(.5*e)/e;return[Math.cos(.5*e),...n.map(i=>t*i)]}function up([n,e,t,i]){return[[1-2*(t*t+i*i),2*(e*t-n*i),2*(e*i+n*t)],[2*(e*t+n*i),1-2*(e*e+i*i),2*(t*i-n*e)],[2*(e*i-n*t),2*(t*i+n*e),1-2*(e*e+t*t)]]}function Qa(n,e){let t=[[1,0,0,0]];for(let i=1;i<n.length;i++){let s=n[i]-n[i-1],[r,o]=[Gt(e,i-1),Gt(e,i)],a=Ys(r,o),l=YI(t[i-1],cp(r.map((u,h)=>.5*s*(u+o[h])+s*s/12*a[h]))),c=Math.hypot(...l);t.push(l.map(u=>u/c))}return t}var Gt=(n,e)=>[n[3*e],n[3*e+1],n[3*e+2]];function el(n,e){let t=n.length,i=new Float64Array(18*t);for(let s=0;s<t;s++){let r=up(n[s]),o=Gt(e,s);for(let a=0;a<3;a++){let l=18*s+6*a;for(let c=0;c<3;c++)i[l+c]=r[a][c]*o[c];u_.forEach(([c,u],h)=>{i[l+3+h]=(r[a][c]*o[u]+r[a][u]*o[c])/c_})}}return i}function hp(n){let e=[0,1,2].map(t=>[0,1,2].map(i=>t===i?n[t]:0));return u_.forEach(([t,i],s)=>{e[t][i]=e[i][t]=n[3+s]/c_}),e}function ZI(n){let e=n.reduce((f,p)=>f+p.elapsed.length,0),t=Array.from({length:6},()=>new Float64Array(3*e)),i=0;for(let{elapsed:f,rates:p}of n){let x=f.length,m=el(Qa(f,p),p),g=yh(m,0,x);for(let y=0;y<x;y++)for(let v=0;v<3;v++,i++)for(let M=0;M<6;M++)t[M][i]=m[18*y+6*v+M]-g[6*v+M]}let{values:s,vectors:r}=l_(t),o=hp(r[5]),a=Math.sign(o[0][0]+o[1][1]+o[2][2])||1,l=To(o.map(f=>f.map(p=>a*p))),[c,u]=l.vectors,h=[c,u,Ys(c,u)],d=[0,1,2].map(f=>h.map(p=>p[f]));return{moments:jI(l.values),axes:d,singularValues:s}}function yh(n,e,t){let i=new Float64Array(18);for(let s=e;s<t;s++)for(let r=0;r<18;r++)i[r]+=n[18*s+r];return i.map(s=>s/(t-e))}function jI(n){let e=.5*(n[0]+n[1]+n[2]),t=Math.max(e-n[0],1e-300),i=Math.max(e-n[1],.02*t),s=Math.max(e-n[2],GI*t),r=[i+s,t+s,t+i].sort((o,a)=>o-a);return r.map(o=>o/r[2])}function h_(n){let e=ZI(n),t=dh(n.map(({rates:u})=>u)),i=n.reduce((u,{elapsed:h})=>u+h.length,0),s=6*t*Math.sqrt(i),r=n.map(({elapsed:u,rates:h})=>{let d=vi(h);return zt(u).map((f,p)=>f*d[p+1])}),o=Math.max(...r.map(u=>u.reduce((h,d)=>h+d,0))),a=Math.max(...r.map(_t)),l=Math.max(...n.map(({rates:u})=>_t(vi(u)))),c=null;return a>HI?c=W("The rates say that the body turns by {angle} rad from sample to sample, too far to be followed: the rates are of another unit, like deg/s, or the times are.",{angle:Mt(a,3)}):l>WI&&e.moments[0]>qI?c=W("The rates, about {rates} rad/s, are beyond what gyros can tell, and make the body nearly a sphere. Both happen where rates in deg/s are read as rad/s: choose their unit.",{rates:Mt(l,3)}):o<VI?c=W("The body turned by {angle} rad only: nothing can be said of its inertia.",{angle:Mt(o,2)}):e.singularValues[4]<s&&(c=KI(n)),{...e,noise:t,degenerate:c}}function KI(n){let e=n.map(({rates:o})=>{let a=vi(o),l=a.length,c=[0,1,2].map(d=>a.reduce((f,p,x)=>f+o[3*x+d],0)/l),u=Math.hypot(...c);return{away:Math.max(...a.map((d,f)=>{let p=Mi(Gt(o,f),c)/Math.max(d*u,1e-300);return Math.acos(Math.min(1,Math.max(-1,p)))/$I})),speed:a.reduce((d,f)=>d+f,0)/l,toward:c.map(d=>d/Math.max(u,1e-300))}}),{away:t,speed:i,toward:s}=e.reduce((o,a)=>a.away>o.away?a:o),r=`(${no(s.map(o=>o.toFixed(2)))})`;return t<XI?W("The rates ({rates} rad/s) stay within {angle}\xB0 of one direction of the device, {axis}: the body spins about a principal axis, or is a sphere; either way the log does not determine the moments. Throw it with a tumble, best about its middle axis.",{rates:Mt(i,3),angle:Mt(t,2),axis:r}):W("Within the noise, bodies of quite different moments fit the rates ({rates} rad/s, up to {angle}\xB0 from {axis}). Throw it longer or faster, with a tumble about its middle axis.",{rates:Mt(i,3),angle:t.toFixed(0),axis:r})}var d_=600,JI=2;function f_(n,e,t,i=0){let{throws:s,windows:r}=n,[o,a]=[nP(n.fit,s[i]),s[i]],{moments:l}=o,c=p_(o,a),[u,h]=hs(c),d=o.starts[i].map((v,M)=>v*l[M]),[f,p]=[a.times[0],a.times.at(-1)],x=Float64Array.from({length:d_},(v,M)=>f+(p-f)*M/(d_-1)),m=n.misfit!==null,g=no([0,1].map(v=>`I${v+1}/I3 ${m?"\u2248":"="} ${dp(l[v],3,m)}`)),y={type:"body",traced:1,shape:"box or ellipsoid of the same inertia",surface:null,ellipsoid:null,changed:!0,azimuth:Math.atan2(h,u)};return{name:t,key:null,summary:W("Free flight from {begin} s to {end} s of the log, and the exact motion of the fitted body: {ratios}.",{begin:Mt(f,4),end:Mt(p,4),ratios:g}),notes:["A gyro tells the moments up to a common factor: on this page the largest is 1 kg m\xB2.",...e.notes],panels:[y,{type:"sphere",title:"Momentum sphere",legend:"other polhodes",words:"L in body axes runs along its polhode; dots are the log's samples",measured:c},{type:"poinsot"}],drift:{},scatters:[],plots:[],times:iP(x),joined:!0,space:null,up:"L",free:l,energyName:"energy",energyUnit:"J",model:{solver:"FreeMotion",moments:l,momentum:d,attitude:[1,0,0,0],epoch:a.epoch},story:QI(n,e,r[i],g)}}function QI({throws:n,windows:e,limit:t,start:i,rest:s,fit:r,misfit:o},a,l,c){let u=a.dialect?W("Read as a log of {app}, rates in {unit}.",{app:a.dialect,unit:a.rateUnit}):W("Rates are read in {unit}, as chosen.",{unit:a.rateUnit}),h=Mt(l.end-l.start,2),d=e.length>1?W("{count} free flights are found; this one lasts {duration} s: {reason}.",{count:e.length,duration:h,reason:W(l.reason)}):W("One free flight is found; it lasts {duration} s: {reason}.",{duration:h,reason:W(l.reason)}),f=o!==null,p=no(r.bias.map(g=>dp(g,3,f))),x=s?"{ratios}; the gyro's bias is {bias} rad/s, which a rest confirms.":"{ratios}; the gyro's bias is {bias} rad/s, and no rest in the log confirms it.",m=r.drag?"The residuals, {rms} rad/s rms, are those of the noise, {noise} rad/s: within it the log is the motion of a rigid body with drag.":"The residuals, {rms} rad/s rms, are those of the noise, {noise} rad/s: within it the log is the motion of a free rigid body.";return[`${u} ${d}`,W(x,{ratios:c,bias:p}),...r.drag?[eP(r.drag,f)]:[],o??W(m,{rms:Mt(r.rms,2),noise:Mt(i.noise,2)}),...t===null?[]:[tP(t,n)]]}function dp(n,e,t){return(t?Mt(n,JI):n.toFixed(e)).replace("-","\u2212")}function eP(n,e){let t=no(n.map(s=>dp(s,4,e))),i=W("The curves are of the free motion that touches it in the middle of the flight.");return`${W("Drag slows it: c/I3 = {numbers} of the torque \u2212c |\u03C9| \u03C9 along the axes.",{numbers:t})} ${i}`}function tP(n,e){let t=e.reduce((i,{times:s})=>i+s.length,0);return W("Samples at the gyro's limit, {limit} deg/s, are left out; {count} remain.",{limit:Mt(n*180/Math.PI,4),count:t})}function nP(n,e){let t=hs(p_(n,e)),i=[t[0]<0?-1:1,1,t[2]<0?-1:1];i[1]=i[0]*i[2];let s=r=>r.map((o,a)=>i[a]*o);return{...n,axes:n.axes.map(s),starts:n.starts.map(s)}}function p_({moments:n,axes:e,bias:t},{rates:i,times:s}){return Array.from(s,(r,o)=>{let a=Gt(i,o).map((u,h)=>u-t[h]),l=n.map((u,h)=>u*(e[0][h]*a[0]+e[1][h]*a[1]+e[2][h]*a[2])),c=Math.hypot(...l)||1;return l.map(u=>u/c)}).flat()}function iP(n){let e="";for(let t of new Uint8Array(n.buffer))e+=String.fromCharCode(t);return{kind:"f8",shape:[n.length],data:btoa(e)}}var sP=[.3,.6,1.2,2.4],rP=2,oP=1,vh=.03,_h=[.3,1],aP=3,lP=.07,cP=4,fp=12,m_=6,g_=2e4,uP=.1;function x_(n,e,t){let i=[];for(let[s,r]of fP(n,vi(e)))for(let o=s;o<=r;o+=g_/2){let a=Math.min(o+g_,r+1);if(n[a-1]-n[o]>=t&&i.push(...pP(n.slice(o,a),e.slice(3*o,3*a),t,o)),a>r)break}return MP(i)}function y_(n,e){let t=el(Qa(n,e),e),i=Math.floor(n.length/4),[s,r]=[i,n.length-i],o=T_(n,t,s,r,w_(t,s,r).inertia);return!o||o.first>s||o.last<r-1?null:{...o,change:E_(t,o.first,o.last+1,o.inertia)}}function __(n,e,t){let i=t.map(({first:l,last:c,change:u})=>{let h=e.slice(3*l,3*c+3),d=el(Qa(n.slice(l,c+1),h),h);return{...v_(d,0,c+1-l),change:u}}),s=t.map((l,c)=>c).sort((l,c)=>t[c].turn-t[l].turn),r=[];for(let l of s){let c=r.find(u=>hP([...u,l].map(h=>i[h])));c?c.push(l):r.push([l])}let[o,a]=[[],-1/0];for(let l of r){let c=l.reduce((u,h)=>u+t[h].turn,0);c>a&&([o,a]=[l,c])}return[t.filter((l,c)=>o.includes(c)),t.filter((l,c)=>!o.includes(c))]}function v_(n,e,t){let i=yh(n,e,t),s=new Float64Array(36);for(let r=e;r<t;r++)M_(s,n,r);return{mean:i,spread:b_(i,s.map(r=>r/(t-e)))}}function M_(n,e,t){for(let i=0;i<3;i++){let s=18*t+6*i;for(let r=0;r<6;r++)for(let o=0;o<6;o++)n[6*r+o]+=e[s+r]*e[s+o]}}function b_(n,e){return[0,1,2,3,4,5].map(t=>[0,1,2,3,4,5].map(i=>e[6*t+i]-n[t]*n[i]-n[6+t]*n[6+i]-n[12+t]*n[12+i]))}var Ro=(n,e,t)=>{let i=0;for(let s=0;s<6;s++)i+=n[e+s]*t[s];return i},S_=(n,e)=>Math.hypot(Ro(n,0,e),Ro(n,6,e),Ro(n,12,e));function hP(n){let e=n.map(({spread:s})=>Math.max(s.reduce((r,o,a)=>r+o[a],0),1e-300)),t=n[0].spread.map((s,r)=>s.map((o,a)=>n.reduce((l,c,u)=>l+c.spread[r][a]/e[u],0))),i=To(t).vectors[0];return n.every(({mean:s,spread:r,change:o})=>{let a=r.reduce((l,c,u)=>l+i[u]*c.reduce((h,d,f)=>h+d*i[f],0),0);return Math.sqrt(Math.max(a,0))/Math.max(S_(s,i),1e-12)<Math.max(vh,3*o)})}var w_=(n,e,t)=>A_(v_(n,e,t));function A_({mean:n,spread:e}){let{values:t,vectors:i}=To(e),s=null;for(let r=0;r<fp;r++){let[o,a]=[Math.cos(Math.PI/fp*r),Math.sin(Math.PI/fp*r)],l=i[0].map((d,f)=>o*d+a*i[1][f]),c=o*o*t[0]+a*a*t[1],u=dP(l),h=u?Math.sqrt(Math.max(c,0))/Math.max(S_(n,l),1e-12):1/0;if((!s||h<s.change)&&(s={inertia:l,change:h}),r===0&&u)break}return s}function dP(n){let e=hp(n),t=Math.sign(e[0][0]+e[1][1]+e[2][2]),{values:i}=To(e.map(s=>s.map(r=>t*r)));return i[0]>.03*i[2]&&i[0]+i[1]>.8*i[2]}function E_(n,e,t,i){let s=yh(n,e,t),r=[0,6,12].map(a=>Ro(s,a,i)),o=0;for(let a=e;a<t;a++)for(let l=0;l<3;l++)o+=(Ro(n,18*a+6*l,i)-r[l])**2;return Math.sqrt(o/(t-e))/Math.max(Math.hypot(...r),1e-12)}function fP(n,e){let t=n.length,i=Array.from(e,c=>c>oP),s=i.map((c,u)=>i.slice(Math.max(u-2,0),u+3).some(Boolean)),r=i.map((c,u)=>c||u>=2&&u+2<t&&s.slice(u-2,u+3).every(Boolean)),o=zt(n),a=Math.max(uP,5*_t(o)),l=[];for(let c=0;c<t;c++)r[c]&&(c>0&&r[c-1]&&o[c-1]<a?l.at(-1)[1]=c:l.push([c,c]));return l}function pP(n,e,t,i){let s=el(Qa(n,e),e),r=vi(e),o=new Float64Array(n.length);for(let c=1;c<n.length;c++)o[c]=o[c-1]+.5*(r[c]+r[c-1])*(n[c]-n[c-1]);let a=new Uint8Array(n.length),l=[];for(let{begin:c,end:u,inertia:h}of mP(n,s,o)){let d=0;for(let m=c;m<u;m++)d+=a[m];if(d/(u-c)>.5)continue;let f=T_(n,s,c,u,h);if(!f||n[f.last]-n[f.first]<t)continue;let{first:p,last:x}=f;a.fill(1,p,x+1),l.push({first:p+i,last:x+i,change:E_(s,p,x+1,f.inertia),turn:o[x]-o[p]})}return l}function mP(n,e,t){let i=[],s=n.length,r=_t(zt(n)),o=gP(e);for(let a of new Set(sP.map(l=>Math.max(6,zi(l/r))))){let l=a>s&&!i.length&&s>=6?s:a,c=[];for(let h=0;h<=s-l;h+=Math.max(1,Math.floor(l/m_)))t[h+l-1]-t[h]>=rP&&c.push(h);let u=c.map(h=>A_(xP(o,h,l)));for(let h of yP(c.length,Math.max(1,Math.floor(c.length/m_)))){let d=h[0];for(let f of h)u[f].change<u[d].change&&(d=f);d!==void 0&&u[d].change<vh&&i.push({begin:c[d],end:c[d]+l,...u[d]})}}return i.sort((a,l)=>a.change-l.change)}function gP(n){let e=n.length/18,[t,i]=[new Float64Array(18*(e+1)),new Float64Array(36*(e+1))];for(let s=0;s<e;s++){for(let o=0;o<18;o++)t[18*(s+1)+o]=t[18*s+o]+n[18*s+o];let r=new Float64Array(36);M_(r,n,s);for(let o=0;o<36;o++)i[36*(s+1)+o]=i[36*s+o]+r[o]}return{total:t,squares:i}}function xP({total:n,squares:e},t,i){let s=t+i,r=Float64Array.from({length:18},(a,l)=>(n[18*s+l]-n[18*t+l])/i),o=Float64Array.from({length:36},(a,l)=>(e[36*s+l]-e[36*t+l])/i);return{mean:r,spread:b_(r,o)}}function yP(n,e){let[t,i]=[Math.floor(n/e),n%e],s=0;return Array.from({length:e},(r,o)=>Array.from({length:t+(o<i?1:0)},()=>s++))}function T_(n,e,t,i,s){let[r,o]=[t,i-1],a=s;for(let l=0;l<cP;l++){let c=Float64Array.from({length:3*n.length},(x,m)=>Ro(e,6*m,a)),u=vP(n,c,r,o),h=_P(us(u.slice(r,o+1)));if(!h)return null;let[d,f]=[r+h[0],r+h[1]-1];for(;d>0&&u[d-1];)d-=1;for(;f<n.length-1&&u[f+1];)f+=1;if(f-d<6)return null;let p=w_(e,d,f+1);if(a=p.inertia,!Number.isFinite(p.change))return null;if(d===r&&f===o)break;[r,o]=[d,f]}return{first:r,last:o,inertia:a}}function _P(n){let e=null;for(let t of n)(!e||t[1]-t[0]>e[1]-e[0])&&(e=t);return e}function vP(n,e,t,i){let s=n.length,r=vi(e).map(x=>Math.max(x,1e-12)),o=(x,m)=>Math.hypot(e[3*m]-e[3*x],e[3*m+1]-e[3*x+1],e[3*m+2]-e[3*x+2]),a=_t(Float64Array.from({length:i-t},(x,m)=>o(t+m,t+m+1)/r[t+m])),l=_t(zt(n)),c=Math.min(Math.max(1,zi(lP/l)),Math.max(1,Math.ceil(4*a/(_h[0]*l)))),u=Float64Array.from({length:Math.max(s-c,0)},(x,m)=>o(m,m+c)/(n[m+c]-n[m])/Math.min(r[m+c],r[m])),h=_t(u.slice(t,Math.max(i-c+1,t+1))),d=Math.min(Math.max(_h[0],aP*h),_h[1]),f=Array.from(u,x=>x<d);for(let[x,m]of us(f.map(g=>!g))){let g=Math.min(m+c-1,s-1);g-x<=2*c+2&&o(x,g)/r[x]<_h[0]*(n[g]-n[x])+2*a&&f.fill(!0,x,m)}let p=new Array(s).fill(!1);return f.forEach((x,m)=>{x&&p.fill(!0,m,m+c+1)}),p}function MP(n){let e=[];for(let t of[...n].sort((i,s)=>i.first-i.last-(s.first-s.last)))e.every(i=>t.last<i.first||t.first>i.last)&&e.push(t);return e.sort((t,i)=>t.first-i.first)}var bh=.3,Mh=.1,bP=.015,SP=.35,wP=.6,AP=1,EP=.03,R_=[8.8,10.8],TP=.3;function pp({times:n,rates:e,accelerationTimes:t,acceleration:i}){let{means:s,size:r}=L_(n,e),o=bP+.5*CP(e),a=N_(s,r,o),l=zt(n);if(n.forEach((d,f)=>{((l[f-1]??0)>=bh||(l[f]??0)>=bh)&&(a[f]=!1)}),i){let d=IP(t,i,n);a.forEach((f,p)=>{a[p]=f&&d[p]})}let c=vi(s).map(d=>d<SP),u=C_(I_(a.map((d,f)=>d&&!!c[f]),n),n,e);if(u.length)return u;let h=d=>[0,1,2].every(f=>Math.abs(s[3*d+f])<wP);return u=C_(I_(a.map((d,f)=>d&&h(f)),n),n,e),i||RP(u,e)?u:[]}function P_(n){let e=pp(n),t=[0,0,0],i=0;for(let[s,r]of e){let o=hs(n.rates,s,r+1),a=r+1-s;for(let l=0;l<3;l++)t[l]+=o[l]*a;i+=a}return i?t.map(s=>s/i):t}function C_(n,e,t){if(!n.length)return[];let i=n.map(([r,o])=>hs(t,r,o+1)),s=0;return n.forEach(([r,o],a)=>{e[o]-e[r]>e[n[s][1]]-e[n[s][0]]&&(s=a)}),n.filter((r,o)=>Math.hypot(...i[o].map((a,l)=>a-i[s][l]))<EP)}function RP(n,e){if(n.length<2)return!1;let t=hs(e,n[0][0],n[0][1]+1);return n.slice(1).some(([i],s)=>{for(let r=n[s][1];r<i;r++)if(Math.hypot(...t.map((o,a)=>e[3*r+a]-o))>AP)return!0;return!1})}function L_(n,e){let t=_t(zt(n)),i=Math.max(1,zi(Mh/t)),s=n.length,r=Math.floor(i/2),o=new Float64Array(e.length);for(let a=0;a<3;a++)for(let l=0;l<s;l++){let c=0;for(let u=l-r;u<l-r+i;u++)c+=e[3*Math.min(Math.max(u,0),s-1)+a];o[3*l+a]=c/i}return{means:o,size:Math.max(2,zi(bh/t))}}function CP(n){let e=[...new Set(Array.from(n.slice(0,6e4),t=>zi(t*1e9)/1e9))].sort((t,i)=>t-i);return e.length>1?_t(zt(e)):0}function N_(n,e,t){let i=n.length/3,s=Math.floor(e/2),r=new Array(i).fill(!0);for(let a=0;a<3;a++){let l=xr(n,a);for(let c=0;c<i;c++){if(!r[c])continue;if(c<s||c>=i-Math.floor((e-1)/2)){r[c]=!1;continue}let[u,h]=[1/0,-1/0];for(let d=c-s;d<c-s+e;d++)u=Math.min(u,l[d]),h=Math.max(h,l[d]);r[c]=h-u<t}}let o=new Array(i).fill(!1);for(let a=0;a<i;a++)if(r[a])for(let l=a-s;l<a-s+e;l++)o[l]=!0;return o}function IP(n,e,t){if(n.length<2)return Array.from(t,()=>!1);let{means:i,size:s}=L_(n,e),r=vi(i),o=N_(i,s,TP).map((a,l)=>a&&r[l]>R_[0]&&r[l]<R_[1]);return Array.from(t,a=>{if(a<n[0]||a>n.at(-1))return!1;let l=Math.min(Math.max($n(n,a,!0)-1,0),n.length-2),c=(a-n[l])/(n[l+1]-n[l]);return(1-c)*Number(o[l])+c*Number(o[l+1])>.5})}function I_(n,e){let t=[];for(let[i,s]of us(n)){let r=i===0?0:$n(e,e[i]+Mh/2),o=s===e.length?s-1:$n(e,e[s-1]-Mh/2,!0)-1;o>r&&e[o]-e[r]>=bh-Mh&&t.push([r,o])}return t}var D_=.3,PP=.05,LP=.35,U_=3,[NP,DP]=[1,4],UP=.02;function F_(n,e){let[t,i]=[n.accelerationTimes,n.acceleration],s=t.length>1?_t(zt(t)):D_,r=Math.max(3,zi(D_/s));if(t.length<r)return[];let o=OP(n),a=zP(n,o,r);if(!a)return[];let l=Float64Array.from(t,(h,d)=>Math.hypot(...o[d].map((f,p)=>i[3*d+p]-f[0]*a[0]-f[1]*a[1]-f[2]*a[2]))),c=Array.from(t,(h,d)=>l[d]<U_&&h>=n.times[0]&&h<=n.times.at(-1)),u=[];for(let[h,d]of FP(us(c),Math.max(2,zi(UP/s)))){let f=Math.max(NP,DP*_t(l.slice(h,d))),[p,x]=[h,d-1];for(;l[p]>=f;)p+=1;for(;l[x]>=f;)x-=1;t[x]-t[p]>=e&&u.push({first:p,last:x})}return u}function FP(n,e){let t=[];for(let[i,s]of n)t.length&&i-t.at(-1)[1]<=e?t.at(-1)[1]=s:t.push([i,s]);return t}function OP(n){let e=BP(n.times,n.rates);return Array.from(n.accelerationTimes,t=>{let[i,s]=[n.rates,e].map(o=>kP(n.times,o,t)),r=[[1,0,0],[0,1,0],[0,0,1]].map(o=>{let[a,l]=[Ys(i,Ys(i,o)),Ys(s,o)];return a.map((c,u)=>c+l[u])});return[0,1,2].map(o=>r.map(a=>a[o]))})}function BP(n,e){let t=new Float64Array(e.length),i=n.length-1;for(let s=0;s<=i;s++)for(let r=0;r<3;r++){let o=c=>e[3*c+r];if(s===0||s===i){let c=s===0?0:i-1;t[3*s+r]=(o(c+1)-o(c))/(n[c+1]-n[c]);continue}let[a,l]=[n[s]-n[s-1],n[s+1]-n[s]];t[3*s+r]=(a*a*o(s+1)+(l*l-a*a)*o(s)-l*l*o(s-1))/(a*l*(a+l))}return t}function kP(n,e,t){if(t<=n[0])return Gt(e,0);if(t>=n.at(-1))return Gt(e,n.length-1);let i=$n(n,t,!0)-1,s=(t-n[i])/(n[i+1]-n[i]),r=Gt(e,i+1);return Gt(e,i).map((o,a)=>o+s*(r[a]-o))}function zP(n,e,t){let[i,s]=[n.accelerationTimes,n.acceleration],r=[];for(let l=0;l+t<=i.length;l+=Math.max(1,Math.floor(t/8))){if(i[l]<n.times[0]||i[l+t-1]>n.times.at(-1))continue;let c=[0,1,2].map(p=>[0,1,2].map(x=>p===x?.001/PP**2:0)),u=[0,0,0],h=0;for(let p=l;p<l+t;p++){let x=Gt(s,p);for(let m=0;m<3;m++){h+=x[m]*x[m]/t;for(let g=0;g<3;g++){u[g]+=e[p][m][g]*x[m]/t;for(let y=0;y<3;y++)c[g][y]+=e[p][m][g]*e[p][m][y]/t}}}let d=gh(c,u),f=d&&h-d.reduce((p,x,m)=>p+x*u[m],0);d&&f<U_**2&&Math.hypot(...d)<LP&&r.push({tells:xh(c),left:f,at:d})}if(!r.length)return null;let o=Math.max(...r.map(({tells:l})=>l));return r.filter(({tells:l})=>l>=.1*o).reduce((l,c)=>c.left<l.left?c:l).at}var mp=8,gp=.25,B_=.15,[GP,VP]=[.004,.1],O_=.1,xp=1-1e-6;function k_(n,e=null){let t=P_(n),{t:i,rates:s}=HP(n.times,n.rates.map((a,l)=>a-t[l%3])),r=n.acceleration?qP(n,i,s):WP(i,s),o=Array.from(n.times).filter((a,l)=>e===null||[0,1,2].every(c=>Math.abs(n.rates[3*l+c])<e*xp));return r.filter(({start:a,end:l})=>$n(o,l,!0)-$n(o,a)>=mp)}function HP(n,e){let t=_t(zt(n)),i=Float64Array.from(n,(c,u)=>Math.max(...[0,1,2].map(h=>Math.abs(e[3*u+h])))),s=Ja(i,.999),r=t>0?Math.trunc(Math.min(GP,VP/Math.max(s,1e-9))/t):1,o=Math.floor(n.length/r);if(r<2||o<2*mp)return{t:n,rates:e};let a=c=>Float64Array.from({length:o},(u,h)=>{let d=0;for(let f=h*r;f<(h+1)*r;f++)d+=c[f];return d/r}),l=[0,1,2].map(c=>a(xr(e,c)));return{t:a(n),rates:Float64Array.from({length:3*o},(c,u)=>l[u%3][Math.floor(u/3)])}}function WP(n,e){let t=x_(n,e,B_).filter(({first:s,last:r})=>n[r]-n[s]>=gp),[i]=__(n,e,t);return i.map(({first:s,last:r})=>({start:n[s],end:n[r],reason:"keeps an angular momentum"}))}function qP(n,e,t){let i=n.accelerationTimes;return F_(n,B_).map(({first:s,last:r})=>({start:i[s],end:i[r],reason:"the accelerometer feels no weight"})).filter(({start:s,end:r})=>r-s>=gp).map(s=>XP(e,t,s))}function XP(n,e,t){let[i,s]=[$n(n,t.start),$n(n,t.end,!0)];if(s-i<mp)return t;let r=y_(n.slice(i,s),e.slice(3*i,3*s));if(!r||r.change>vh)return t;let[o,a]=[n[i+r.first],n[i+r.last]];return o-t.start>O_||t.end-a>O_||a-o<gp?t:{...t,start:r.first===0?t.start:o,end:r.last===s-i-1?t.end:a}}var Sh=3,yp=.03,$P=-.1,YP=.003,[ZP,jP]=[6,25],z_=1e-6,_p=.02,KP=.04,JP=1e-6;function vp(n,e,t,i=!1){let[s,r]=n.moments,o=t??{value:[0,0,0],spread:[yp,yp,yp]},a={shape:[r-s,.5*(s+r-1)],axes:n.axes,bias:[...o.value],drag:i?[0,0,0]:null,starts:e.map(({rates:l,zero:c})=>eL(n.axes,Gt(l,c).map((u,h)=>u-o.value[h])))};for(let l of[100,500,2500,1/0])l<1/0&&!e.some(({elapsed:c})=>c.length>2*l)||(a=iL(a,e.map(c=>QP(c,l)),o));return aL(a,Co(a,e))}function QP({elapsed:n,rates:e,zero:t},i){if(!Number.isFinite(i))return{elapsed:n,rates:e,zero:t};let s=Math.max(t-i/2,0),r=Math.min(t+i/2,n.length);return{elapsed:n.slice(s,r),rates:e.slice(3*s,3*r),zero:t-s}}var eL=(n,e)=>[0,1,2].map(t=>n[0][t]*e[0]+n[1][t]*e[1]+n[2][t]*e[2]),V_=([n,e])=>[.5*(1-n)+e,.5*(1+n)+e,1];function Co({shape:n,axes:e,bias:t,drag:i,starts:s},r){let o=V_(n);return Math.min(...o)>YP?r.map(({elapsed:a,rates:l},c)=>{let u=i?null:new yi({moments:o,momentum:o.map((f,p)=>f*s[c][p])}),h=i&&tL(o,i,s[c],a),d=new Float64Array(l.length);return a.forEach((f,p)=>{let x=h?h[p]:u.angularVelocity(f);for(let m=0;m<3;m++)d[3*p+m]=l[3*p+m]-t[m]-Mi(e[m],x)}),d}):null}function tL(n,e,t,i){let[s,r,o]=n,a=([h,d,f])=>{let p=Math.hypot(h,d,f);return[((r-o)*d*f-e[0]*p*h)/s,((o-s)*f*h-e[1]*p*d)/r,((s-r)*h*d-e[2]*p*f)/o]},l=new Array(i.length),c=$n(i,0),u=(h,d,f)=>{let[p,x]=[t,0];for(let m=h;m!==d;m+=f){let g=Math.max(1,Math.ceil(Math.hypot(...p)*Math.abs(i[m]-x)/KP)),y=(i[m]-x)/g;for(let v=0;v<g;v++)p=nL(a,p,y);[l[m],x]=[p,i[m]]}};return u(c,i.length,1),u(c-1,-1,-1),l}function nL(n,e,t){let i=(l,c)=>e.map((u,h)=>u+c*t*l[h]),s=n(e),r=n(i(s,.5)),o=n(i(r,.5)),a=n(i(o,1));return e.map((l,c)=>l+t/6*(s[c]+2*r[c]+2*o[c]+a[c]))}function H_(n,e){let t=up(cp(e.slice(2,5))),i=s=>[0,1,2].map(r=>t[r][s]);return{shape:[Math.min(Math.max(n.shape[0]+e[0],-1),1),Math.min(Math.max(n.shape[1]+e[1],$P),2)],axes:n.axes.map(s=>[0,1,2].map(r=>Mi(s,i(r)))),bias:n.bias.map((s,r)=>s+e[5+r]),starts:n.starts.map((s,r)=>s.map((o,a)=>o+e[8+3*r+a])),drag:n.drag&&n.drag.map((s,r)=>s+e[8+3*n.starts.length+r])}}function iL(n,e,t){let i=n,s=Co(i,e);if(!s)return i;let r=_t(s.flatMap(o=>Array.from(o,Math.abs)))*1.5+1e-9;for(let o=0;o<ZP;o++){i=rL(i,e,t,r);let a=r;if(r=sL(Co(i,e),W_(i)),Math.abs(r/a-1)<.02)break}return i}var W_=({starts:n,drag:e})=>8+3*n.length+(e?3:0);function sL(n,e){let t=n.flatMap(r=>Array.from({length:r.length/3},(o,a)=>Mi(Gt(r,a),Gt(r,a)))),i=16*(_t(t)/2.366+1e-300),s=t.reduce((r,o)=>r+Math.min(o,i),0);return Math.max(Math.sqrt(s/Math.max(3*t.length-e,1)),1e-12)}function rL(n,e,t,i){let[s,r,o]=[n,Co(n,e),.001];for(let a=0;a<jP;a++){let{normal:l,right:c}=oL(s,e,r,t,i),u=G_(r,s,t,i),h=null;for(;!h&&o<1e12;){let d=gh(l.map((m,g)=>m.map((y,v)=>v===g?y*(1+o)+1e-300:y)),c),f=d&&H_(s,d),p=f&&Co(f,e),x=p?G_(p,f,t,i):1/0;x<u?h={tried:f,residuals:p,next:x}:o*=10}if(!h||([s,r]=[h.tried,h.residuals],o=Math.max(o/10,1e-12),u-h.next<JP*u))break}return s}function G_(n,{bias:e,drag:t},i,s){let r=e.reduce((o,a,l)=>o+((a-i.value[l])/i.spread[l])**2,0);for(let o of t??[])r+=(o/_p)**2;for(let o of n)for(let a of o){let l=Math.abs(a/s);r+=l<=Sh?l*l:Sh*(2*l-Sh)}return r}function oL(n,e,t,i,s){let r=W_(n),o=Array.from({length:r},(c,u)=>{let h=u<5||u>=8+3*e.length?z_:z_*Math.max(1,...n.starts.flat().map(Math.abs)),[d,f]=[h,-h].map(p=>Co(H_(n,Array.from({length:r},(x,m)=>m===u?p:0)),e));return!d||!f?t.map(p=>new Float64Array(p.length)):d.map((p,x)=>p.map((m,g)=>(f[x][g]-m)/(2*h)))}),a=Array.from({length:r},()=>new Array(r).fill(0)),l=new Array(r).fill(0);t.forEach((c,u)=>c.forEach((h,d)=>{let f=Math.min(1,Sh*s/Math.max(Math.abs(h),1e-300))/s**2;for(let p=0;p<r;p++){let x=f*o[p][u][d];l[p]+=x*h;for(let m=0;m<=p;m++)a[p][m]+=x*o[m][u][d]}}));for(let c=0;c<r;c++)for(let u=0;u<c;u++)a[u][c]=a[c][u];for(let c=0;c<3;c++)a[5+c][5+c]+=i.spread[c]**-2,l[5+c]+=(i.value[c]-n.bias[c])/i.spread[c]**2;return(n.drag??[]).forEach((c,u)=>{let h=8+3*e.length+u;a[h][h]+=_p**-2,l[h]-=c/_p**2}),{normal:a,right:l}}function aL({shape:n,axes:e,bias:t,drag:i,starts:s},r){let o=V_(n),a=[0,1,2].sort((d,f)=>o[d]-o[f]),l=e.map(d=>a.map(f=>d[f])),c=xh(l)<0?-1:1,u=o[a[2]],h=(r??[]).flatMap(d=>[...d]);return{moments:a.map(d=>o[d]/u),axes:l.map(([d,f,p])=>[d,f,c*p]),bias:t,drag:i&&a.map(d=>i[d]/u),starts:s.map(d=>a.map((f,p)=>(p===2?c:1)*d[f])),residuals:r??[],rms:Math.sqrt(h.reduce((d,f)=>d+f*f,0)/Math.max(h.length,1))}}var wh=3,lL=[125,245,250,500,1e3,2e3,4e3,143.4,286.7,573.4,1146.9,2293.8,4587.5].map(n=>n*Math.PI/180),cL=.0012,uL=.03,hL=1.5,dL=3,fL=3,q_=6,X_=1e-6,[pL,mL]=[20,32],gL=.8;function $_(n){let e=[];for(let a=0;a<n.length;a+=3)(a===0||[0,1,2].some(l=>n[a+l]!==n[a-3+l]))&&e.push(n[a],n[a+1],n[a+2]);let t=Float64Array.from(e);if(t.length/3<2*wh)return null;let i=Math.max(...[0,1,2].map(a=>Y_(xr(t,a).map(Math.abs)))),s=xL(t).filter(({level:a})=>a>(1-uL)*i),r=a=>s.some(({axis:l,side:c})=>l!==a.axis||c!==a.side),o=s.filter(a=>Z_(a.level)||a.runs>1||r(a)).map(({edge:a})=>a);return o.length?Math.min(...o):null}var Y_=n=>Float64Array.from(n).sort().at(-wh),Z_=n=>lL.some(e=>Math.abs(n/e-1)<cL);function xL(n){let e=[0,1,2].map(r=>xr(n,r)),t=e.map(r=>{let o=zt(Array.from(new Set(r)).sort((a,l)=>a-l));return{step:o.length?Ja(o,.05):0,noise:dh([r],1)}}),i=t.map(({step:r})=>r).filter(r=>r>0),s=[];return e.forEach((r,o)=>{let a=r.reduce((u,h)=>Math.max(u,Math.abs(h)),0),l=Math.max(i.length?Math.min(...i):0,X_*a),{noise:c}=t[o];for(let u of[1,-1]){let h=r.map(f=>u*f),d=Y_(h);for(let[f,p]of[[d,l],[d-.5*q_*c,q_*c]]){let x=p>0&&f>pL*p?yL(h,f,p):0;if(x){s.push({edge:p===l?d:f-p/2,level:f,axis:o,side:u,runs:x});break}}}}),s}function yL(n,e,t){let i=n.map(x=>(e-x)/t),s=Array.from(i,x=>Math.abs(x)<.5+1e-6),r=s.filter(Boolean).length,o=x=>i.reduce((m,g,y)=>m+ +(g<x&&!s[y]&&g>0),0),[a,l]=[o(4.5),o(16.5)];if(r<wh||a>(hL-1)*r)return 0;let c=us(Array.from(i,x=>x<16.5)).filter(([x,m])=>s.slice(x,m).filter(Boolean).length>=wh).length,u=n.filter((x,m)=>s[m]),[h,d]=u.reduce(([x,m],g)=>[Math.min(x,g),Math.max(m,g)],[1/0,-1/0]);if(Z_(e)&&d-h<=X_*e)return Math.max(c,1);let f=l<dL*a&&l>fL*2*Math.max(c,1);return i.reduce((x,m)=>Math.max(x,m),-1/0)<mL||r>gL*n.length||f?0:c}var j_=8,_L=1.4,vL=2,ML=.3,bL=.2,SL=.9,wL=.003;function AL(n){let e=$_(n.rates),t=k_(n,e);if(!t.length)throw new dt(W("no free flight was found in the log: no stretch of a quarter of a second keeps an angular momentum, or feels no weight. Throw it with a spin of a turn a second or more, and log from before the throw until after the catch."));return{limit:e,windows:t,throws:t.map(i=>EL(n,i,e))}}function EL({times:n,rates:e},{start:t,end:i},s){let r=Array.from(n.keys()).filter(l=>n[l]>=t&&n[l]<=i&&(s===null||Gt(e,l).every(c=>Math.abs(c)<s*xp)));if(r.length<j_)throw new dt(W("a throw must have {least} samples that are not at the gyro's limit; got {count}. Throw more slowly.",{least:j_,count:r.length}));let o=Math.floor(r.length/2),a=n[r[o]];return{times:Float64Array.from(r,l=>n[l]),elapsed:Float64Array.from(r,l=>n[l]-a),rates:Float64Array.from(r.flatMap(l=>Gt(e,l))),zero:o,epoch:a}}function TL(n,e){let t=pp(n).map(([a,l])=>({start:n.times[a],end:n.times[l],mean:hs(n.rates,a,l+1)})).filter(a=>!e.some(({start:l,end:c})=>a.start<c&&a.end>l)),i=t.reduce((a,{start:l,end:c})=>a+c-l,0);if(!(i>0))return null;let s=a=>[0,1,2].map(l=>t.reduce((c,u)=>c+(u.end-u.start)/i*a(u,l),0)),r=s((a,l)=>a.mean[l]),o=s((a,l)=>(a.mean[l]-r[l])**2);return{value:r,spread:o.map(a=>Math.hypot(wL,Math.sqrt(a)))}}function J_(n){let{limit:e,windows:t,throws:i}=AL(n),s=h_(i);if(s.degenerate)throw new dt(s.degenerate);let r=TL(n,t),o=vp(s,i,r),a=K_(o,s.noise)&&vp(s,i,r,!0),l=a&&a.rms<SL*o.rms?a:o,c=i.flatMap(({rates:h})=>Array.from(h,d=>d*d)),u=Math.sqrt(c.reduce((h,d)=>h+d,0)/c.length);if(!(l.rms<bL*u))throw new dt(W("no free motion of a rigid body explains the log: the residuals, {residuals} rad/s, are not small beside the rates, {rates} rad/s. Check columns and units, or log a free flight.",{residuals:Mt(l.rms,2),rates:Mt(u,2)}));return{throws:i,windows:t,limit:e,start:s,rest:r,fit:l,misfit:K_(l,s.noise)}}function K_({residuals:n,rms:e,drag:t},i){let s=n.flatMap(f=>Array.from(f,Math.abs)),[r,o]=[_t(s)/.6745,s.reduce((f,p)=>f+p*p,0)],l=n.reduce((f,p)=>f+p.slice(3).reduce((x,m,g)=>x+m*p[g],0),0)/Math.max(o,1e-300),c=f=>f<100?Mt(f,2):f.toFixed(0),u=null;if(r>_L*i?u=W("{times} times the noise of a sample",{times:c(r/i)}):l>ML?u=W("alike from sample to sample (correlation {correlation})",{correlation:$t(l.toFixed(2))}):e>vL*i&&(u=W("larger than the noise at a few samples, up to {most} rad/s",{most:Mt(Math.max(...s),2)})),!u)return null;let h={rms:Mt(e,2),noise:Mt(i,2),why:u};return`${W(t?"The log is not the motion of a rigid body with drag within its noise: the residuals ({rms} rad/s rms, noise {noise} rad/s) are {why}.":"The log is not a free rigid body's motion within its noise: the residuals ({rms} rad/s rms, noise {noise} rad/s) are {why}.",h)} ${W("A gyro's gains, a clock that jitters or a catch within the window do that; polhode fit fits gains too, and gives errors.")}`}var Q_=64e6,RL="or drop it on this page: phyphox, Sensor Logger, AndroSensor, Betaflight, or any table with a time and three angular velocities. It stays on this computer.",Cn=(n,e={},...t)=>{let i=Object.assign(document.createElement(n),e);return i.append(...t),i},Ah=class{constructor(e,t){this.open=t,this.input=Cn("input",{type:"file",accept:".csv,.txt,.tsv,text/csv,text/plain",hidden:!0}),this.input.addEventListener("change",()=>{this.input.files.length&&this.take(this.input.files[0]),this.input.value=""}),this.button=Cn("button",{type:"button",className:"wide"}),this.button.addEventListener("click",()=>this.input.click()),this.said=Cn("p",{id:"log-said"}),this.said.setAttribute("role","status"),this.form=Cn("form",{id:"log-columns",hidden:!0}),this.form.addEventListener("submit",i=>{i.preventDefault(),this.fit()}),this.hint=Cn("span",{className:"hint"}),this.root=Cn("section",{id:"log"},Cn("p",{},this.button," ",this.hint),this.input,this.said,this.form),e.after(this.root),this.listen(),this.write()}write(){this.button.textContent=W("Open a gyro log\u2026"),this.hint.textContent=W(RL),this.root.setAttribute("aria-label",W("A log of your own")),this.form.hidden||this.ask(),this.found&&!document.querySelector("#presets [aria-pressed=true]")&&this.fit()}listen(){let e=i=>[...i.dataTransfer?.types??[]].includes("Files"),t=i=>document.documentElement.classList.toggle("dropping",i);window.addEventListener("dragover",i=>{e(i)&&(i.preventDefault(),t(!0))}),window.addEventListener("dragleave",i=>!i.relatedTarget&&t(!1)),window.addEventListener("drop",i=>{e(i)&&(i.preventDefault(),t(!1),i.dataTransfer.files.length&&this.take(i.dataTransfer.files[0]))})}async take(e){this.form.hidden=!0,this.name=e.name;try{if(e.size>Q_)throw new dt(W("it has {size} MB, and at most {most} MB are read. Cut the log to the throw.",{size:Math.round(e.size/1e6),most:Q_/1e6}));let t=await e.text();if(t.startsWith("PK"))throw new dt(W("it is a zip archive. Unpack it, and choose the table inside, like Gyroscope.csv or Raw Data.csv."));this.table=i_(t),this.mapping=s_(this.table),this.ask();let{time:i,timeUnit:s,gyro:r,rateUnit:o}=this.mapping;i!==null&&s&&r&&o?await this.fit():this.say(W("no app that is known writes such a header. Choose what the columns are, and the units that the file does not say."))}catch(t){this.refuse(t)}}ask(){let{form:e,dialect:t}=this.table,{time:i,timeUnit:s,gyro:r,rateUnit:o}=this.mapping,a=Array.from({length:e.width},(h,d)=>[d,e.names[d]||mh(d)]),l=h=>Object.keys(h).map(d=>[d,d]);this.fields={time:yr("time",a,i),timeUnit:yr("unit of the time",l(ls),s),x:yr("angular velocity x",a,r?.[0]),y:yr("angular velocity y",a,r?.[1]),z:yr("angular velocity z",a,r?.[2]),rateUnit:yr("its unit",l(cs),o)};let c=Cn("summary",{textContent:W("Columns and units")}),u=Cn("details",{open:!t},c,...Object.values(this.fields),Cn("button",{type:"submit",className:"wide",textContent:W("Read the log")}));this.form.replaceChildren(u),this.form.hidden=!1}async fit(){let e=Object.fromEntries(Object.entries(this.fields).map(([s,r])=>[s,r.querySelector("select").value])),t=s=>e[s]===""?null:Number(e[s]),i={time:t("time"),timeUnit:e.timeUnit,gyro:["x","y","z"].map(t),rateUnit:e.rateUnit};this.mapping=i,this.say(W("fitting\u2026")),await new Promise(s=>setTimeout(s,30));try{this.log=r_(this.table,i),this.found=J_(this.log),this.show(CL(this.found.windows))}catch(s){this.refuse(s)}}show(e){let t=f_(this.found,this.log,this.name,e);this.open(t);for(let o of document.querySelectorAll("#presets button"))o.setAttribute("aria-pressed","false");document.getElementById("story").replaceChildren(...t.story.map(o=>Cn("li",{textContent:o}))),this.say("");let{windows:i}=this.found;if(i.length<2)return;let s=i.map(({start:o,end:a},l)=>[l,W("{least} to {most}",{least:`${Mt(o,4)} s`,most:`${Mt(a,4)} s`})]),r=yr("which throw",s,e);r.querySelector("select").addEventListener("change",o=>this.show(Number(o.target.value))),this.said.replaceChildren(r)}refuse(e){if(!(e instanceof dt||e instanceof RangeError))throw e;this.say(e.message,!0)}say(e,t=!1){this.said.textContent=e&&`${this.name}: ${e}`,this.said.classList.toggle("wrong",t)}};function CL(n){let e=0;return n.forEach(({start:t,end:i},s)=>{i-t>n[e].end-n[e].start&&(e=s)}),e}function yr(n,e,t){let i=Cn("select",{required:!0}),s=t!=null;return s||i.append(Cn("option",{value:"",textContent:W("choose\u2026")})),i.append(...e.map(([r,o])=>Cn("option",{value:String(r),textContent:o,selected:s&&r===t}))),Cn("label",{},`${W(n)} `,i)}var tl=Math.SQRT2,[IL,PL]=[.5,8],LL=1.5,ev=[.5,1.6],Mp=20,[tv,NL]=[8,240],[DL,UL]=[1,3600],nv=20,Eh=class{constructor(e,{seek:t,beyond:i,told:s}){this.root=e,this.seek=t,this.beyond=i,this.told=s,this.position=0,this.playing=!1,this.looping=!1,this.goesOn=!1,this.slider=e.querySelector("#seek"),this.play=e.querySelector("#play"),this.loop=e.querySelector("#loop"),this.speed=e.querySelector("#speed"),this.shown=e.querySelector("#now");let r=(o,a)=>e.querySelector(o).addEventListener("click",a);r("#play",()=>this.toggle()),r("#back",()=>this.step(-1)),r("#forth",()=>this.step(1)),r("#loop",()=>this.repeat()),r("#slower",()=>this.scale(1/tl)),r("#faster",()=>this.scale(tl)),this.slider.addEventListener("input",()=>{this.pause(),this.go(Number(this.slider.value))}),document.addEventListener("keydown",o=>this.key(o))}take(e,t,i=null,s=null){this.motion=e,this.slider.max=String(e.count-1),this.single=e.count<2||!(e.span>0);for(let r of this.root.querySelectorAll("button, input"))r.disabled=this.single;this.loop.hidden=!!e.endless,t&&(this.rate=FL(e,s),this.pause()),i===null?this.go(0):this.goTo(i)}key(e){if(this.single||e.ctrlKey||e.metaKey||e.altKey||e.target!==this.slider&&e.target.closest?.("input, select, textarea"))return;let t=e.target===this.slider,i=e.target.closest?.("button, a, summary");if(e.target.closest?.("canvas")&&e.key.startsWith("Arrow"))return;let r={" ":()=>!i&&this.toggle(),k:()=>this.toggle(),l:()=>this.repeat(),ArrowLeft:()=>!t&&this.step(e.shiftKey?-nv:-1),ArrowRight:()=>!t&&this.step(e.shiftKey?nv:1),Home:()=>!t&&this.home(),End:()=>!t&&this.to(this.motion.count-1),"+":()=>this.scale(tl),"=":()=>this.scale(tl),"-":()=>this.scale(1/tl)}[e.key];r&&r()!==!1&&e.preventDefault()}toggle(){if(this.playing)return this.pause();this.position>=this.motion.count-1&&!this.motion.endless&&!this.goesOn&&this.go(0),this.playing=!0,this.begun=null,this.say(),requestAnimationFrame(e=>this.tick(e))}pause(){this.playing=!1,this.say()}repeat(){this.looping=!this.looping,this.say()}home(){if(!this.motion.endless)return this.to(0);this.pause(),this.beyond(this.motion.solver.epoch)}tick(e){if(!this.playing)return;let t=this.begun===null?0:Math.min((e-this.begun)/1e3,.25);this.begun=e,this.advance(this.time+t*this.rate),this.playing&&requestAnimationFrame(i=>this.tick(i))}advance(e){let t=this.motion.times[this.motion.count-1];if(e<=t)return this.goTo(e);if(this.motion.endless||this.goesOn&&!this.looping)return this.beyond(e);if(this.looping)return this.goTo(this.motion.times[0]+(e-t)%this.motion.span);this.goTo(t),this.pause()}step(e){this.to(Math.round(this.position)+e)}to(e){this.pause(),this.go(e)}go(e){this.position=Math.min(this.motion.count-1,Math.max(0,e)),this.time=this.motion.at(this.position).time,this.refresh()}goTo(e){this.time=e,this.position=this.motion.positionOf(e),this.refresh()}refresh(){this.slider.value=String(Math.round(this.position)),this.slider.style.setProperty("--part",`${100*this.position/Math.max(1,this.motion.count-1)}%`);let e=En(this.time,Math.max(this.motion.span,Math.abs(this.time)));this.slider.setAttribute("aria-valuetext",e),this.shown.textContent=e,this.seek(this.position,this.time)}scale(e){let{span:t}=this.motion;this.rate=Math.min(t/DL,Math.max(t/UL,this.rate*e)),this.say()}quicken(e){e!==null&&e>Mp*this.rate&&(this.rate=iv(e/Mp)),this.say()}say(){this.play.setAttribute("aria-label",W(this.playing?"Pause":"Play")),this.play.dataset.playing=String(this.playing),this.loop.setAttribute("aria-pressed",String(this.looping)),this.rate&&(this.speed.textContent=Math.abs(this.rate-1)<.05?W("real time"):`\xD7${et(this.rate,2)}`),this.told()}};function FL(n,e){if(!(n.span>0))return 1;let t=n.hasUp?PL:IL,i=n.fastest?2*Math.PI*t/n.fastest:n.span/40,s=n.solver?.nutationPeriod,r=s&&Number.isFinite(s)?s/LL:1/0,o=Math.min(n.span/tv,Math.max(n.span/NL,Math.min(i,r))),a=Math.min(n.span/tv,(e??0)/Mp);if(o>ev[0]&&o<ev[1]&&a<=1)return 1;if(a>o)return iv(a);let l=10**Math.floor(Math.log10(o));return([5,2,1].find(u=>u*l<=o*1.0001)??1)*l}function iv(n){let e=10**Math.floor(Math.log10(n));return[1,2,5,10].find(t=>t*e>=.9999*n)*e}var Ep={};ps(Ep,{BufferGeometry:()=>xt,Color:()=>Fe,ConeGeometry:()=>bs,CylinderGeometry:()=>fi,DataTexture:()=>di,Float32BufferAttribute:()=>tt,Group:()=>ut,InstancedMesh:()=>Ko,LinearFilter:()=>Ft,Matrix4:()=>Qe,Mesh:()=>Ye,MeshBasicMaterial:()=>dn,MeshLambertMaterial:()=>vn,PlaneGeometry:()=>ir,Quaternion:()=>rt,SphereGeometry:()=>zn,Vector3:()=>C,circle:()=>ki,contactSound:()=>ov,decimal:()=>$t,dot:()=>Ws,drawUpTo:()=>as,endsLegend:()=>wp,floor:()=>So,globe:()=>bo,line:()=>Kt,mapGlobe:()=>rv,mappedGlobe:()=>Sp,newPanel:()=>qn,pairThrough:()=>Ua,path:()=>os,pieces:()=>Mo,polhodeThrough:()=>ur,say:()=>W,specks:()=>pr,unpacked:()=>ht});var bp=[[33,102,172],[178,24,43]],sv=247,OL=6;function BL(){let n=new Uint8Array(1024);for(let e=0;e<256;e++){let t=e<127.5?0:1,i=Math.abs(e-127.5)/127.5;for(let s=0;s<3;s++)n[4*e+s]=Math.round(sv+(bp[t][s]-sv)*i**.8);n[4*e+3]=255}return n}function kL(n,e,t){let i=e*t,s=(a,l,c)=>Array.from({length:a},(u,h)=>{let d=(h+.5)/t-.5,f=Math.floor(d),p=x=>c?(x+l)%l:Math.min(Math.max(x,0),l-1);return[p(f),p(f+1),d-f]}),r=s(i,e,!0),o=s(n*t,n,!1);return(a,l,c)=>{o.forEach(([u,h,d],f)=>{let p=l+u*e,x=l+h*e;for(let m=0;m<i;m++){let[g,y,v]=r[m],M=a[p+g]+v*(a[p+y]-a[p+g]),w=a[x+g]+v*(a[x+y]-a[x+g]);c[f*i+m]=M+d*(w-M)}})}}function Sp(n,e){let t=n*e,i=BL(),s=new Uint8Array(4*t),r=new di(s,e,n);r.magFilter=r.minFilter=Ft,r.colorSpace="srgb";let o=new zn(1,96,64);return o.rotateX(Math.PI/2),o.rotateZ(Math.PI),{mesh:new Ye(o,new dn({map:r})),paint:(c,u=null)=>{for(let h=0;h<t;h++){let d=Math.round(c[h]);if(s.set(i.subarray(4*d,4*d+4),4*h),u?.(h))for(let f=0;f<3;f++)s[4*h+f]*=.35}r.needsUpdate=!0},pixels:s}}var wp=n=>[{color:`rgb(${bp[1].join(", ")})`,text:n[1]},{color:`rgb(${bp[0].join(", ")})`,text:n[0]}];function rv(n,e,{title:t,words:i,legend:s}){let r=n.lines?OL:1,[o,a]=[n.rows*r,n.columns*r],l=ht(n.levels),c=n.lines?ht(n.lines):null,u=ht(n.frames),[h,d]=[n.rows*n.columns,o*a],f=kL(n.rows,n.columns,r),{mesh:p,paint:x,pixels:m}=Sp(o,a),[g,y,v]=[new Float32Array(d),new Float32Array(d),new Uint8Array(d)],M=qn(e,{title:t,words:i,radius:1.3});M.scene.add(p);for(let b of[-.5,0,.5])M.scene.add(ki(1.002*Math.sqrt(1-b*b),1.002*b,e.family));M.legend=wp(s);let w=(b,I,T,L)=>{if(f(b,h*I,g),L!==0){f(b,h*T,y);for(let D=0;D<d;D++)g[D]+=L*(y[D]-g[D])}},E=b=>{let I=b%a===a-1?b+1-a:b+1,T=b+a<d?b+a:b;return v[b]!==v[I]||v[b]!==v[T]},_=-1;return M.update=b=>{if(b.position===_)return;_=b.position;let I=0;for(;I<u.length-2&&u[I+1]<=b.position;)I++;let T=Math.min(I+1,u.length-1),L=T>I?Math.min(1,(b.position-u[I])/(u[T]-u[I])):0;if(c){w(c,I,T,L);for(let D=0;D<d;D++)v[D]=Math.floor(g[D]/256*n.bands)}w(l,I,T,L),x(g,c&&E)},M.probe=()=>({shown:_,pixels:[...m.subarray(0,16)]}),M}var Ap=class{constructor(){this.on=!1,this.context=null,this.rate=0}toggle(){this.on=!this.on,this.on&&!this.context&&this.make(),this.on?this.context.resume():this.quiet()}make(){this.context=new AudioContext;let e=Float32Array.from({length:49},(t,i)=>i?1:0);this.oscillator=this.context.createOscillator(),this.oscillator.setPeriodicWave(this.context.createPeriodicWave(e,new Float32Array(49))),this.gain=this.context.createGain(),this.gain.gain.value=0,this.oscillator.connect(this.gain).connect(this.context.destination),this.oscillator.start()}follow(e){if(this.rate=e,!this.on)return;let{currentTime:t}=this.context;this.oscillator.frequency.setTargetAtTime(Math.min(e,2e3),t,.03),this.gain.gain.setTargetAtTime(e>0?.25:0,t,.03),clearTimeout(this.waiting),this.waiting=setTimeout(()=>this.quiet(),150)}quiet(){this.gain?.gain.setTargetAtTime(0,this.context.currentTime,.03)}probe(){return{on:this.on,rate:this.rate,frequency:this.oscillator?.frequency.value??null,gain:this.gain?.gain.value??null}}},ov=new Ap;var zL={axis:uy,body:Sy,poinsot:wy,sphere:Cy,...globalThis.polhodePanels},Jt=n=>document.getElementById(n),Tp=class{constructor(e,t){this.language=t,t.changed=()=>this.retell(),this.view=new hu(()=>this.draw()),this.stage=new ih(this.view),this.panels=[],this.outgoing=[],this.canvases=[],this.waiting=null;let i=window.matchMedia("(prefers-color-scheme: dark)");this.theme=i.matches?$s.dark:$s.light,i.addEventListener("change",r=>this.dress(r.matches?$s.dark:$s.light)),Jt("theme").addEventListener("click",()=>this.dress(this.theme===$s.dark?$s.light:$s.dark)),Jt("reset").addEventListener("click",()=>this.instrument?.reset());for(let r of document.querySelectorAll("button"))r.addEventListener("pointerup",()=>r.blur());new ResizeObserver(()=>this.sizes()!==this.shapes&&this.draw()).observe(Jt("panels")),this.room=new Ku(["summary","refused","facts","notes","readouts","plots"].map(Jt)),this.plots=new rh(Jt("plots"),r=>{this.timebar.pause(),this.goTo(r)}),this.timebar=new Eh(Jt("timebar"),{seek:(r,o)=>this.show(r,o),beyond:r=>this.goTo(r),told:()=>this.told()}),this.address=new ol(()=>this.seen,r=>this.follow(r,e)),this.views=new ju(Jt("panels"),()=>this.looked()),this.sharing=new uh(this),this.playground=e.presets?new ah(e.presets,r=>this.open(r),r=>this.tell(r)):null,e.presets&&(this.reader=new Ah(Jt("share"),r=>this.open(r)));let s=this.address.read();this.open(this.playground?.find(s.tables.preset)??e,s)}follow(e,t){let{tables:i}=e;i.lang!==(this.language.asked??void 0)&&(this.language.take(i.lang),this.playground?.write(),this.reader?.write()),this.open(this.playground?.find(i.preset)??t,e)}open(e,t=null){let i=this.timebar.playing;this.data=e,Jd(e),this.room.release(),this.view.letGo(),this.view.elevation=e.panels[0].elevation??this.view.elevation,this.view.azimuth=e.panels[0].azimuth??this.view.azimuth,this.instrument=null,Jt("refused").textContent="",this.shaped=!1,Jt("instrument").hidden=!e.model,Jt("facts").replaceChildren(),e.model&&(this.instrument=new Yu(e.model,s=>this.reset(s)),this.epoch=this.instrument.setting.epoch),this.motion=e.model&&!e.attitude?this.instrument.motion(GL(e),e.space):new Vu(e),Jt("panels").replaceChildren(),this.canvases=e.panels.map(s=>$g(s,this.view)),this.canvases.forEach((s,r)=>this.listen(s,r)),this.views.take(e.panels.map(({type:s})=>s)),this.readouts=new lh(Jt("readouts"),this.motion,e),this.now=this.motion.at(0),this.build(),this.timebar.goesOn=!!this.instrument,this.timebar.take(this.motion,!0,null,this.instrument?.event),this.sharing.take(),t&&this.restore(t),i&&this.timebar.toggle(),this.address.write()}retell(){let{position:e,time:t}=this.now,i={...this.seen,t:e||t!==this.begins?t:null};this.playground?.write(),this.reader?.write(),this.open(this.data,{tables:i,refused:[]})}restore({tables:{t:e=null,preset:t,view:i=null,lang:s,...r},refused:o}){let[a,l]=[Jt("refused"),[...o]],c=()=>{a.textContent&&l.push({message:a.textContent}),a.textContent=""},u=Object.keys(r);u.length&&!this.instrument?l.push(new RangeError(`This motion has nothing to set; got ${Pn(u.join(", "))} in the link. Leave that out.`)):u.length&&this.instrument.set(r),c(),t!==void 0&&!this.playground&&l.push(new RangeError(`This page shows one motion; got preset=${Pn(t)} in the link. Leave that out.`)),s!==void 0&&!cr().includes(s)&&l.push(new RangeError(`lang must be ${cr().join(" or ")}; got ${Pn(s)}. Name one of these.`)),i!==null&&!this.views.enlarge(String(i))&&l.push(new RangeError(`view must be ${this.views.types.join(" or ")}; got ${Pn(i)}. Name one of these.`)),e!==null&&typeof e!="number"?l.push(new RangeError(`t must be a time in seconds; got ${Pn(e)}. Write it as a number, as in t=4.`)):e!==null&&this.goTo(e),c(),a.textContent=l.map(({message:h})=>h).join(" ")}get seen(){let{key:e}=this.data,{named:t}=this.views,i=!this.timebar.playing&&this.now.time!==this.begins;return{...this.language.asked?{lang:this.language.asked}:{},...e?{preset:e}:{},...this.instrument?.tables,...t?{view:t}:{},...i?{t:this.now.time}:{}}}get begins(){return this.instrument?.setting.epoch??this.motion.times[0]}tell({set:e,view:t}){return t?this.views.enlarge(t):(e&&this.instrument?.set(e)?this.timebar.quicken(this.instrument.event):e||this.instrument?.reset(),this.goTo(this.begins),!av()&&!this.timebar.playing&&this.timebar.toggle(),this.address.write())}looked(){this.view.letGo(),this.draw(),this.address.write()}told(){this.sharing&&this.motion&&this.sharing.suggest(),this.instrument!==void 0&&this.address.changed()}reset(e){this.room.keep();let{epoch:t}=this.instrument.setting,i=t===this.epoch?this.now.time:t;this.epoch=t,this.shaped=e,Jt("summary").textContent=W(this.instrument.isAsGiven?this.data.summary:"Set on this page.");let s=this.instrument.motion();this.motion=s.around(i),this.readouts.take(this.motion,this.data,!0),this.build(),this.timebar.take(this.motion,!1,i),this.sharing.suggest(),this.room.keep(),this.address.changed()}build(){this.outgoing.push(...this.panels),document.documentElement.dataset.theme=this.theme.name,this.panels=this.data.panels.map(t=>{let i=this.changedPanel(t);return Object.assign(zL[t.type](this.motion,i,this.theme,Ep),{type:t.type})}),this.panels.forEach((t,i)=>Yg(this.canvases[i],t,this.data,()=>this.draw()));let e=this.instrument&&!this.instrument.isAsGiven;this.plots.take(this.motion,e?{...this.data,scatters:[],plots:[]}:this.data,this.theme),this.draw()}changedPanel(e){return this.shaped&&e.type==="body"?{...e,surface:null,ellipsoid:null,changed:!0}:this.instrument&&!this.instrument.isAsGiven&&e.type==="sphere"?{...e,changed:!0,equilibria:null}:e}dress(e){this.theme=e,this.build()}show(e,t){this.now=this.motion.endless?{position:e,...this.motion.solvedAt(t)}:this.motion.at(e),this.timebar.playing||this.address.changed(),this.draw()}goTo(e){let t;try{t=this.windowAt(e)}catch(i){return this.timebar.pause(),Jt("refused").textContent=i.message,!1}return t!==this.motion?(this.motion=t,this.build(),this.timebar.take(t,!1,e)):this.timebar.goTo(e),!0}windowAt(e){let{times:t,count:i,endless:s}=this.motion;if(!Number.isFinite(e))throw new RangeError(`t must be a finite number of seconds; got ${Pn(e)}. Give a nearer time.`);if(s)return this.motion.around(e);if(e>=t[0]&&e<=t[i-1])return this.motion;if(this.instrument)return this.instrument.motion().around(e);throw new RangeError(`t must be from ${t[0]} to ${t[i-1]} s, where this motion has samples; got ${e}. Give a time between these.`)}draw(){this.waiting??=requestAnimationFrame(()=>this.drawNow())}drawNow(){cancelAnimationFrame(this.waiting),this.waiting=null,this.shapes=this.sizes();for(let e of this.panels)e.update(this.now);this.stage.draw(this.panels,this.canvases,this.theme),this.clear(),this.plots.draw(this.now),this.readouts.show(this.now),this.sharing.frame(),window.polhode.drawn+=1,window.polhode.firstPicture??=performance.now()}clear(){for(let e of this.outgoing)ly(e.scene);this.outgoing=[]}drawn(){return this.waiting&&this.drawNow(),this}sizes(){return this.canvases.map(e=>`${e.clientWidth} ${e.clientHeight}`).join()}listen(e,t){let i=s=>{let r=e.getBoundingClientRect();return[(s.clientX-r.left)/r.width*2-1,1-(s.clientY-r.top)/r.height*2]};e.addEventListener("pointerdown",s=>{let r=this.panels[t];if(s.button!==0||!r.grasp||!this.instrument?.kind.dragged||!r.grasp(i(s),e.clientWidth))return;s.stopImmediatePropagation(),this.timebar.pause(),e.setPointerCapture(s.pointerId);let o=l=>{let c=this.panels[t].under(i(l));c&&(this.now={...this.now,time:this.instrument.setting.epoch},this.instrument.point(c))},a=()=>{e.removeEventListener("pointermove",o);for(let l of["pointerup","pointercancel"])e.removeEventListener(l,a)};e.addEventListener("pointermove",o);for(let l of["pointerup","pointercancel"])e.addEventListener(l,a)},{capture:!0})}shot(e=null){e||this.drawn();let t=this.canvases[this.views.large],i=e??document.createElement("canvas");e||([i.width,i.height]=[t.width,t.height].map(l=>l-l%2));let s=i.getContext("2d");s.fillStyle=this.theme.ground,s.fillRect(0,0,i.width,i.height);let r=Math.min(i.width/t.width,i.height/t.height),[o,a]=[t.width*r,t.height*r];return s.drawImage(t,.5*(i.width-o),.5*(i.height-a),o,a),i}},av=()=>window.matchMedia("(prefers-reduced-motion: reduce)").matches,GL=n=>ht(n.times);function VL(n){return{drawn:0,firstPicture:null,get count(){return n.motion.count},get times(){return n.motion.times},view:n.view,enlarge:e=>n.views.enlarge(e),shown:()=>({theme:n.theme.name,position:n.now.position,time:n.now.time}),seek(e){n.timebar.to(e),n.drawNow()},goTo(e){let t=n.goTo(e);return n.drawn(),t},get playing(){return n.timebar.playing},set:e=>n.instrument?.set(e)??!1,settings:()=>n.instrument?.kind.asSpec(n.instrument.setting)??null,state(e){let t=n.motion.endless?n.motion:n.instrument?.motion([e]),i=t?t.solvedAt(e):n.motion.at(n.motion.positionOf(e)),{w:s,x:r,y:o,z:a}=i.attitude??{};return{attitude:i.attitude?[s,r,o,a]:null,momentum:i.momentum?.toArray()??null}},spec:()=>n.instrument?.toml(n.motion.span)??null,plots:()=>n.drawn().plots.probe(),names:()=>n.drawn().panels.map(e=>e.boxes??[]),measure(e,...t){n.drawn();let i=n.panels.find(s=>s.type===e)?.probe();return i&&t.length?Object.fromEntries(t.map(s=>[s,i[s]])):i}}}try{let n=JSON.parse(Jt("motion").textContent);window.polhode={drawn:0,firstPicture:null};let e=new Zu;e.take(rl(window.location.hash).tables.lang),Jd(n.presets?n.presets[0]:n);let t=new Tp(n,e);window.polhode=VL(t),window.seek=i=>window.polhode.seek(i),t.draw(),!av()&&t.motion.count>1&&t.motion.span>0&&requestAnimationFrame(()=>t.timebar.toggle())}catch(n){let e=Jt("failure");throw e.hidden=!1,e.textContent=W("The pictures cannot be drawn ({why}). They need a browser with WebGL 2.",{why:n.message}),n}})();
